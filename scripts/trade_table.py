# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors against costs of the variants of a trade: numbers and sentences (doc/guides/convergence-study.md)."""

import math


class NoReference(Exception):
    """No variant that the reference means has succeeded."""


def text(value, digits=6):
    return f"{value:.{digits}g}"


def per_cent(share):
    """Two digits, but no powers of ten."""
    value = 100. * share
    return (text(value, 2) if value < 99.5 else str(math.floor(value + .5))) + " %"


class Table:
    """Variants and quantities are numbered from 0, as trade.json lists them.

    The error of a variant's value v against the reference r is |v / r - 1|. The variant that is the
    reference has none. A variant is on the Pareto front of a cost if none is at most as costly and
    at most as far off, and better in one of the two.

    A variant is richer than another with more DoFs, meshes at least as fine, and the same theory
    or one that holds it, if neither changes other entries of the scene. A poor theory can be
    right by accident, where a curve of errors changes its sign: then a richer one is further
    off. Such a variant is not to be counted on for a tolerance that a richer one misses.
    """

    def __init__(self, trade):
        self.variants, self.quantities = trade["variants"], trade["quantities"]
        self.tolerances, self.phases = trade["tolerances"], trade["phases"]
        self.against = (None if trade["reference"] == "given"
                        else self._find_reference(trade["reference"]))

    def _find_reference(self, name):
        for k in reversed(range(len(self.variants))):
            variant = self.variants[k]
            if name in ("finest", variant["name"]) or (name == "solid" and variant["is_solid"]):
                if not variant["failure"]:
                    return k
                if variant["name"] == name:
                    raise NoReference(f"the variant '{name}', which is the reference, failed: "
                                      + variant["failure"])
        if name == "solid":
            raise NoReference("no variant with hexahedra succeeded, so there is no reference.")
        raise NoReference("no variant of the hierarchy succeeded. The first failed because: "
                          + self.variants[0]["failure"])

    # ---- numbers

    def reference(self, q):
        return (self.quantities[q]["given"] if self.against is None
                else self.variants[self.against]["values"][q])

    def has_error(self, k, q):
        return (not self.variants[k]["failure"] and k != self.against
                and self.reference(q) != 0.)

    def error(self, k, q):
        return abs(self.variants[k]["values"][q] / self.reference(q) - 1.)

    def made_bar(self, k, q):
        """Whether the variant says something of its own error, a bar or that it has none."""
        return bool(self.variants[k]["bars"]) and self.variants[k]["bars"][q] is not None

    def bar(self, k, q):
        """Relative to the reference, as the error is; None where there is none."""
        if not self.made_bar(k, q) or self.reference(q) == 0.:
            return None
        own = self.variants[k]["bars"][q]
        return own["bar"] / abs(self.reference(q)) if own["trusted"] else None

    def is_richer(self, other, k):
        a, b = self.variants[other], self.variants[k]
        return (k in a["holds"] and a["axis"] >= b["axis"] and a["section"] >= b["section"]
                and not a["overridden"] and not b["overridden"] and a["dofs"] > b["dofs"])

    def richer_and_worse(self, k, q, least):
        """The first variant that is richer and off by more than `least`, or None."""
        return next((other for other in range(len(self.variants)) if self.is_richer(other, k)
                     and self.has_error(other, q) and self.error(other, q) > least), None)

    def is_accident(self, k, q):
        # A chance of less than 0.1 % does no harm.
        return self.richer_and_worse(k, q, max(2. * self.error(k, q), 1e-3)) is not None

    def front(self, q, cost):
        """The variants of the Pareto front without accidents, by rising cost: `seconds`, `dofs`."""
        front = []
        for k in sorted((k for k in range(len(self.variants))
                         if self.has_error(k, q) and not self.is_accident(k, q)),
                        key=lambda k: (self.variants[k][cost], self.error(k, q))):
            if not front or self.error(k, q) < self.error(front[-1], q):
                front.append(k)
        return front

    def within(self, q, tolerance):
        return [k for k in range(len(self.variants))
                if self.has_error(k, q) and self.error(k, q) <= tolerance]

    def cheapest_of(self, variants):
        """Seconds that differ by less than those of two equal runs, 5 % and 0.1 s, count as
        equal, and the fewer DoFs decide. None of no variants."""
        least = min((self.variants[k]["seconds"] for k in variants), default=0.)
        return min((k for k in variants if self.variants[k]["seconds"] <= 1.05 * least + .1),
                   key=lambda k: self.variants[k]["dofs"], default=None)

    def cheapest(self, q, tolerance):
        return self.cheapest_of(self.within(q, tolerance))

    def cheapest_to_count_on(self, q, tolerance):
        return self.cheapest_of([k for k in self.within(q, tolerance)
                                 if self.richer_and_worse(k, q, tolerance) is None])

    def nearest_to_reference(self):
        """The variant whose largest error is the smallest, and that error; None without errors."""
        largest = {}
        for k in range(len(self.variants)):
            errors = [self.error(k, q) for q in range(len(self.quantities))
                      if self.has_error(k, q)]
            if errors:
                largest[k] = max(errors)
        return min(largest.items(), key=lambda item: item[1], default=(None, 0.))

    # ---- sentences

    def basis(self):
        """What errors are taken against, and how sure that is."""
        if self.against is None:
            return "Errors are against the values given in the scene."
        said = f"Errors are against {self.variants[self.against]['name']}."
        k, off = self.nearest_to_reference()
        if k is None:
            return said
        name = self.variants[k]["name"]
        # What is further away tells nothing of how sure the reference is.
        if off > .05:
            return (f"{said} No other variant comes near it in all quantities (the nearest, {name}, "
                    f"is off by up to {per_cent(off)}), so nothing here tells how sure it is.")
        return (f"{said} The nearest to it, {name}, is off by up to {per_cent(off)}: errors "
                "smaller than that say little.")

    def beyond_linear(self):
        """What errors against a linear reference do not say: stiffening above 1 % and a buckling
        factor below 10, of the reference or of the variant of most DoFs."""
        good = [k for k, variant in enumerate(self.variants) if not variant["failure"]]
        if self.against is None and not good:
            return ""
        variant = self.variants[max(good, key=lambda k: self.variants[k]["dofs"])
                          if self.against is None else self.against]
        parts = []
        if variant["stiffening"] > 1e-2:
            parts.append("stiffening " + per_cent(variant["stiffening"]))
        if variant["buckling_factor"] is not None and variant["buckling_factor"] < 10.:
            parts.append("buckling factor " + text(variant["buckling_factor"], 4))
        return parts and (
            "All variants are linear, and none of these errors says what large deflections do. By "
            f"{variant['name']}: {', '.join(parts)} (doc/theory/beyond-linear.md).") or ""

    def count_of_bars(self):
        """How many bars of values that have an error are at least that; empty without bars."""
        n_bars = n_holding = n_more = n_without = 0
        for k in range(len(self.variants)):
            for q in range(len(self.quantities)):
                if not self.has_error(k, q) or not self.made_bar(k, q):
                    continue
                own = self.bar(k, q)
                if own is None:
                    n_without += 1
                    continue
                its = 0. if self.against is None else self.bar(self.against, q) or 0.
                n_bars += 1
                n_holding += self.error(k, q) <= own
                n_more += own < self.error(k, q) <= own + its
        if n_bars + n_without == 0:
            return ""
        more = f" ({n_more} more with the reference's own bar added)" if n_more else ""
        return (f"Bars that hold, with the error at most the bar: {n_holding} of {n_bars}{more}; "
                f"values without a bar: {n_without}.")

    def described(self, k, q):
        variant = self.variants[k]
        return (f"{variant['name']}: {variant['dofs']} DoFs, {text(variant['seconds'], 2)} s "
                f"(off by {per_cent(self.error(k, q))}).")

    def sentence(self, q, tolerance):
        """The cheapest variant within the tolerance, and whether to count on it."""
        limit = f"For {text(100. * tolerance, 3)} % in {self.quantities[q]['label']}"
        or_else = "." if self.against is None else " but the reference itself."
        if self.reference(q) == 0.:
            return (f"{limit} there is no answer: the reference is zero, and no error is relative "
                    "to it.")
        k = self.cheapest(q, tolerance)
        if k is None:
            return f"{limit} no variant is enough{or_else}"
        said = f"{limit} the cheapest is {self.described(k, q)}"
        other = self.richer_and_worse(k, q, tolerance)
        if other is None:
            return said
        sure = self.cheapest_to_count_on(q, tolerance)
        return (f"{said} Do not count on it: {self.variants[other]['name']}, which is richer, is off "
                f"by {per_cent(self.error(other, q))}. "
                + (f"There is none to count on{or_else}" if sure is None else
                   f"The cheapest to count on is {self.described(sure, q)}"))
