// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/base/text.h>
#include <lamella/base/version.h>
#include <lamella/export/calculix_deck.h>
#include <lamella/export/calculix_mesh.h>
#include <lamella/recover/sampler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <sstream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    using Json = nlohmann::ordered_json;

    /// A probe with the points of its mean, one list per row (ply).
    struct LocatedProbe
    {
      const Probe           *probe;
      std::vector<BoxPoints> rows;
    };

    /// Throws InputError for analyses that a deck cannot have.
    void
    check_buckling(const Scene &scene)
    {
      const Entry buckling("Find", "buckling");
      const bool  buckles = scene.find.n_buckling_modes > 0;
      if (buckles && !scene.contacts.empty())
        buckling.refuse("export.buckling-with-contact: CalculiX has no closed "
                        "contacts in a buckling step",
                        "Remove buckling from Find, or Contacts.");
      if (buckles && scene.solve.rotations == Rotations::large)
        buckling.refuse("export.buckling-with-large-rotations: linear buckling "
                        "multiplies the stresses of linear kinematics",
                        "Write Rotations = linear, or remove buckling.");
      if (scene.find.response)
        Entry("Find", "response")
          .refuse("export.response: the exported file has no steady harmonic "
                  "response",
                  "Write Find = modes, and add *STEADY STATE DYNAMICS to the "
                  "exported file.");
    }



    /// Throws InputError for loads, supports and obstacles whose factors differ
    /// from the load factor of the scene, which multiplies the whole step.
    void
    check_histories(const Scene &scene)
    {
      if (const std::string path = first_with_factors(scene); !path.empty())
        throw InputError(
          path + "/Factors",
          "",
          "export.load-factors: the exported file has one load factor per step",
          "Remove Factors, or write *AMPLITUDE into the exported file.");
    }



    std::optional<double>
    parse_stiffness(const std::string &text)
    {
      if (text.empty() || text == "auto")
        return {};
      return Entry("--contact-stiffness", text).positive();
    }



    /// Writes both files, or neither and keeps the old ones.
    void
    write_files(const std::filesystem::path &deck,
                const std::string           &deck_text,
                const std::filesystem::path &meaning,
                const std::string           &meaning_text)
    {
      const std::string place = "--output " + deck.string() + ": ";
      if (std::filesystem::is_directory(meaning) ||
          std::filesystem::is_directory(deck))
        throw InputError("export.output-is-folder: " + deck.string() + " or " +
                         meaning.string() +
                         " is a folder. Name another output file.")
          .at(place);
      OutputFile first(deck.string()), second(meaning.string());
      const bool written = (first.stream() << deck_text << std::flush) &&
                           (second.stream() << meaning_text << std::flush) &&
                           first.commit() && second.commit();
      if (!written)
        throw InputError("base.cannot-write: the file cannot be written. Name "
                         "a file in a folder that you may write to.")
          .at(place);
    }



    /// All that a deck is written from.
    struct Deck
    {
      Deck(const Scene                 &scene,
           const std::string           &element,
           const std::optional<double> &contact_stiffness)
        : scene(scene)
        , mesh(scene, CalculixElement(element))
        , conditions(scene, mesh)
        , contacts(scene, mesh, contact_stiffness)
      {
        check_histories(scene);
        check_buckling(scene);
        for (const Probe &probe : scene.probes)
          {
            probes.push_back({&probe,
                              box_points(*mesh.bodies()[probe.body],
                                         probe.position,
                                         probe.box,
                                         "Probe " + probe.name)});
          }
      }

      void
      write(std::ostream &deck) const
      {
        deck << "** " << (scene.title.empty() ? "A scene" : scene.title)
             << "\n** written by lamella " << version()
             << (is_large() ? ": large rotations" : ": linear kinematics")
             << ", units " << scene.units.length << ", " << scene.units.force
             << ", " << scene.units.stress << '\n';
        mesh.write(deck);
        conditions.write_sets(deck);
        contacts.write_model(deck);
        write_output_sets(deck);
        if (conditions.has_static_steps())
          write_static_steps(deck);
        write_mode_steps(deck);
      }

      /// What the deck's numbers mean.
      Json
      meaning() const
      {
        Json json;
        json["version"]  = version();
        json["title"]    = scene.title;
        json["element"]  = mesh.element().name();
        json["units"]    = {{"length", scene.units.length},
                            {"force", scene.units.force},
                            {"stress", scene.units.stress}};
        json["dofs"]     = 3 * mesh.n_nodes();
        json["nodes"]    = mesh.n_nodes();
        json["elements"] = mesh.n_elements();
        json["bodies"]   = Json::object();
        for (unsigned int body = 0; body < scene.bodies.size(); ++body)
          {
            const auto &[node, element]             = mesh.first_of(body);
            const auto &[node_, element_]           = mesh.first_of(body + 1);
            json["bodies"][scene.bodies[body].name] = {
              {"set", "BODY" + std::to_string(body + 1)},
              {"nodes", node_ - node},
              {"elements", element_ - element}};
          }
        json["steps"] = Json::array();
        if (conditions.has_static_steps())
          for (const LoadFactor &factor : scene.solve.load_factors)
            json["steps"].push_back(factor.of_scene());
        if (scene.find.modes)
          json["modes"] = {{"rigid", conditions.n_rigid_motions()},
                           {"number", n_modes()},
                           {"range", scene.find.modes->range.has_value()}};
        json["supports"] = meaning_of_supports();
        json["contacts"] = meaning_of_contacts();
        json["probes"]   = Json::object();
        for (const LocatedProbe &probe : probes)
          json["probes"][probe.probe->name] = meaning_of_probe(probe);
        return json;
      }

      const Scene              &scene;
      CalculixMesh              mesh;
      CalculixConditions        conditions;
      CalculixContacts          contacts;
      std::vector<LocatedProbe> probes;

    private:
      void
      write_output_sets(std::ostream &deck) const
      {
        std::set<unsigned int> nodes, elements;
        for (const LocatedProbe &probe : probes)
          for (const BoxPoints &points : probe.rows)
            for (const auto &point : points)
              for (const Location::Place &place : point.second.places)
                {
                  const unsigned int element =
                    mesh.element_of(probe.probe->body, place.cell);
                  elements.insert(element);
                  nodes.insert(mesh.nodes_of(element).begin(),
                               mesh.nodes_of(element).end());
                }
        if (probes.empty())
          return;
        deck << "** the elements that hold the probes, and their nodes\n";
        write_set(deck, "*NSET, NSET=PROBES", nodes);
        write_set(deck, "*ELSET, ELSET=PROBES", elements);
      }

      void
      write_output(std::ostream &deck) const
      {
        if (!probes.empty())
          deck << "*NODE PRINT, NSET=PROBES\nU\n"
                  "*EL PRINT, ELSET=PROBES, GLOBAL=YES\nS\n";
        for (unsigned int s = 0; s < scene.supports.size(); ++s)
          for (unsigned int c = 0; c < 3; ++c)
            if (!conditions.nodes(s, c).empty())
              deck << "*NODE PRINT, NSET=" << CalculixConditions::set_name(s, c)
                   << ", TOTALS=ONLY\nRF\n";
        contacts.write_output(deck);
        // For pictures, at the end of the step.
        deck << "*NODE FILE, FREQUENCY=100000\nU\n"
                "*EL FILE, FREQUENCY=100000\nS\n";
      }

      void
      write_static_steps(std::ostream &deck) const
      {
        const auto &factors = scene.solve.load_factors;
        // CalculiX makes them shorter where it has to.
        const double first_increment =
          1. / std::max(scene.solve.substeps.number, 1u);
        for (unsigned int step = 0; step < factors.size(); ++step)
          {
            deck << "** load factor " << to_text(factors[step].of_scene())
                 << "\n*STEP, INC=1000" << (is_large() ? ", NLGEOM" : "")
                 << "\n*STATIC\n"
                 << calculix_number(first_increment) << ", 1.\n";
            conditions.write_step(deck, factors[step].of_scene());
            contacts.write_step(deck, factors[step].of_scene());
            write_output(deck);
            deck << "*END STEP\n";
          }
      }

      /// Writes the steps of natural modes, about the state after the static
      /// steps if there are any, and of buckling modes.
      void
      write_mode_steps(std::ostream &deck) const
      {
        const FindRequest &find = scene.find;
        if (find.modes)
          {
            const bool is_stressed = conditions.has_static_steps();
            deck << "** natural modes\n*STEP"
                 << (is_stressed ? ", PERTURBATION" : "") << "\n*FREQUENCY\n"
                 << n_modes() + conditions.n_rigid_motions();
            if (find.modes->range)
              deck << ", " << calculix_number(find.modes->range->first) << ", "
                   << calculix_number(find.modes->range->second);
            deck << '\n';
            if (!is_stressed)
              conditions.write_step(deck, 0.);
            deck << "*NODE FILE\nU\n*END STEP\n";
          }
        if (find.n_buckling_modes > 0)
          {
            deck << "** buckling modes\n*STEP\n*BUCKLE\n"
                 << find.n_buckling_modes << '\n';
            conditions.write_step(deck,
                                  scene.solve.load_factors.back().of_scene());
            deck << "*NODE FILE\nU\n*END STEP\n";
          }
      }

      /// Returns the number of elastic modes to compute: CalculiX needs one for
      /// a range, too.
      unsigned int
      n_modes() const
      {
        return scene.find.modes->range ? 50 : scene.find.modes->number;
      }
      bool
      is_large() const
      {
        return scene.solve.rotations == Rotations::large;
      }
      /// Elements of one row of a probe on @p body, with places, weights.
      Json
      meaning_of_row(const BoxPoints &points, const unsigned int body) const
      {
        Json               row;
        const unsigned int ply = points.front().second.ply;
        const bool         one_ply =
          std::all_of(points.begin(), points.end(), [ply](const auto &point) {
            return point.second.ply == ply;
          });
        row["ply"] = one_ply ? ply + 1 : 0;
        for (const auto &[weight, location] : points)
          for (const Location::Place &place : location.places)
            {
              const unsigned int element = mesh.element_of(body, place.cell);
              Json               natural;
              for (unsigned int d = 0; d < 3; ++d)
                natural.push_back(2. * place.unit[d] - 1.);
              row["elements"].push_back(
                {{"element", element},
                 {"nodes", mesh.nodes_of(element)},
                 {"natural", natural},
                 {"weight", weight / location.places.size()}});
            }
        return row;
      }

      Json
      meaning_of_probe(const LocatedProbe &located) const
      {
        const Probe &probe = *located.probe;
        Json         json;
        json["body"] = scene.bodies[probe.body].name;
        json["at"] = {probe.position[0], probe.position[1], probe.position[2]};
        json["plies"] = Json::array();
        for (const BoxPoints &points : located.rows)
          json["plies"].push_back(meaning_of_row(points, probe.body));
        for (const Reference &reference : probe.references)
          json["references"].push_back({{"quantity", reference.quantity},
                                        {"value", reference.value},
                                        {"source", reference.source}});
        return json;
      }

      Json
      meaning_of_supports() const
      {
        Json json = Json::object();
        for (unsigned int s = 0; s < scene.supports.size(); ++s)
          {
            Json &support = json[scene.supports[s].name] = Json::object();
            for (unsigned int c = 0; c < 3; ++c)
              if (!conditions.nodes(s, c).empty())
                support[std::string(1, "xyz"[c])] = {
                  {"set", CalculixConditions::set_name(s, c)},
                  {"nodes", conditions.nodes(s, c).size()},
                  {"load", conditions.load_vector_on(s, c)}};
          }
        return json;
      }

      Json
      meaning_of_contacts() const
      {
        Json json = Json::object();
        for (unsigned int k = 0; k < contacts.contacts().size(); ++k)
          {
            const CalculixContact &contact = contacts.contacts()[k];
            json[contact.name]             = {
                          {"slave", CalculixContacts::surface_name(k, true)},
                          {"master", CalculixContacts::surface_name(k, false)},
                          {"slave_is_second", contact.slave_is_second},
                          {"tied", scene.contacts[k].is_tied()},
                          {"stiffness", contact.stiffness}};
          }
        return json;
      }
    };

  } // namespace



  void
  export_calculix(const Scene       &scene,
                  const DeckRequest &request,
                  std::ostream      &out)
  {
    const std::filesystem::path name = request.output;
    if (name.extension() != ".inp")
      throw InputError(
        "export.not-inp: the file name must end in .inp, as in beam.inp.")
        .at("--output " + request.output + ": ");
    const Deck         deck(scene,
                    request.element.empty() ? "C3D20R" : request.element,
                    parse_stiffness(request.contact_stiffness));
    std::ostringstream text;
    deck.write(text);
    std::filesystem::path beside = name;
    beside.replace_extension(".json");
    write_files(name, text.str(), beside, deck.meaning().dump(1) + "\n");

    out << "CalculiX deck " << name.string() << ": " << deck.mesh.n_elements()
        << ' ' << deck.mesh.element().name() << ", " << 3 * deck.mesh.n_nodes()
        << " DoFs\n";
    for (const CalculixContact &contact : deck.contacts.contacts())
      out << "Contact " << contact.name
          << ": pressure over penetration = " << contact.stiffness << '\n';
    out << "Run it with: ccx " << beside.replace_extension("").string()
        << std::endl;
  }
} // namespace lamella
