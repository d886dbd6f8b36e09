// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_model_key_h
#define lamella_estimate_model_key_h

#include <lamella/scene/scene.h>

#include <string>

namespace lamella
{
  /**
   * What tells the model of @p scene from all others: the text of all entries
   * as it was read (Scene::resolved), and of what a program may have changed
   * since, every member: of the bodies theory, pieces, axis, refinement and
   * stabilisation, how often sections are divided, and the law of each contact.
   * Numbers have all of their digits. Two scenes with one key give the same
   * numbers of their last load factor.
   *
   * A member that is added to one of these structures does not compile here
   * before it is named, in the key or among those that nobody changes once the
   * text is read.
   */
  std::string
  key_of(const Scene &scene);
} // namespace lamella

#endif
