# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the variants of a trade, each a process of its own, and their records
(doc/guides/convergence-study.md)."""

import ctypes
import json
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

# Runs that take less than SHORT seconds are repeated: the fastest of TRIES counts.
SHORT, TRIES = 1., 3
DISPLACEMENTS, STRESSES = ("ux", "uy", "uz"), ("sxx", "syy", "szz", "sxy", "sxz", "syz")
PR_SET_PDEATHSIG = 1


class InputError(Exception):
    """A fault of the input; exit status 1."""


class NumericsError(Exception):
    """A failure of the numerics; exit status 2."""


class Interrupted(BaseException):
    """SIGINT or SIGTERM, to this process or to one of its children."""

    def __init__(self, number):
        super().__init__()
        self.number = number


def folder_name(number, name):
    """Letters, digits, '-' and '.'; file systems end names at 255 bytes."""
    return f"{number:02d}_{re.sub('[^A-Za-z0-9.-]', '_', name)}"[:100]


def found_in(values, label):
    """The entry of a label. A label without a ply, of a quantity with References, may stand for one
    with a ply: `middle: syz` for `middle/2: syz`. None if there is no entry."""
    if label in values:
        return values[label]
    return next((value for own, value in values.items()
                 if re.sub(r"/\d+:", ":", own) == label), None)


def stamps_of(files):
    """Size and time of the last change of each file."""
    return {path: [os.stat(path).st_size, os.stat(path).st_mtime_ns] if os.path.exists(path)
            else None for path in files}


def environment():
    """Without the variables of MPI: a variant must not join the processes of this one."""
    return {name: value for name, value in os.environ.items()
            if name.startswith("OMPI_ALLOW")
            or not name.startswith(("PMIX_", "ORTE_", "OMPI_"))}


def numbers_of(summary):
    """What a record keeps of summary.json."""
    nonlinear = summary.get("beyond_linear", {})
    goals = summary.get("goals", {})
    return {"dofs": summary["dofs"], "memory": summary["peak_memory_mb"],
            "phases": summary["seconds"],
            "values": {**summary["quantities"],
                       **{label: goal["value"] for label, goal in goals.items()}},
            "bars": {label: {"bar": goal.get("bar", 0.), "trusted": goal["trusted"]}
                     for label, goal in goals.items()},
            "probes": summary["probes"],
            "stiffening": nonlinear.get("stiffening", 0.),
            "buckling_factor": nonlinear.get("buckling_factor")}


def largest_at(probe, rows):
    """Labels of the largest displacement and stress in the lowest ply of a probe."""
    for columns in (DISPLACEMENTS, STRESSES):
        largest = max(columns, key=lambda column: abs(rows[0][column]))
        ply = f"/{rows[0]['ply']}" if len(rows) > 1 and columns is STRESSES else ""
        yield f"{probe}{ply}: {largest}"


def value_of(numbers, label):
    """The value of a quantity, or of a column of a probe; None if there is none."""
    value = found_in(numbers["values"], label)
    name, _, column = label.partition(": ")
    probe, _, ply = name.partition("/")
    if value is None:
        rows = numbers["probes"].get(probe, [])
        if not ply and column not in DISPLACEMENTS and len(rows) > 1:
            return None
        value = next((row.get(column) for row in rows if not ply or str(row["ply"]) == ply), None)
    return value


def has_values(numbers, labels):
    return all(value_of(numbers, label) is not None for label in labels)


class Runs:
    """Runs the variants of `plan` (take_plan()) in the folder of the trade."""

    def __init__(self, plan, folder):
        self.plan, self.folder = plan, folder
        self.labels = [quantity["label"] for quantity in plan["quantities"]]
        files = set(plan["files"]).union(*(one.get("files", ()) for one in plan["variants"]))
        self.stamps = stamps_of(sorted(files))
        for variant in plan["variants"]:
            if not variant["failure"]:
                # The scene's own file is in the parameters already.
                own = [plan["program"], *variant["files"]]
                variant["fingerprint"] += ", " + json.dumps(stamps_of(own))
        self.libc = ctypes.CDLL(None)
        self.children, self.interrupted = set(), False

    def begin_child(self):
        """Of the child before its program: it ends with this process, and at its time limit."""
        if sys.platform == "linux":
            self.libc.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        if self.plan["time_limit"] > 0.:
            hard = resource.getrlimit(resource.RLIMIT_CPU)[1]
            seconds = math.ceil(self.plan["time_limit"])
            if hard == resource.RLIM_INFINITY or seconds < hard:
                resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))

    def run(self, overrides, output, errors, *options):
        """Exit status and seconds of the program with the scene and overrides."""
        words = [self.plan["program"], self.plan["scene"], *options,
                 "--threads", str(self.plan["threads"])]
        for override in overrides:
            words += ["--set", override]
        begin = time.monotonic()
        with open(output, "w", encoding="utf-8") as out, \
                open(errors, "w", encoding="utf-8") as err:
            child = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                     env=environment(), preexec_fn=self.begin_child)
            self.children.add(child)
            status = child.wait()
            self.children.discard(child)
        if self.interrupted or -status in (signal.SIGINT, signal.SIGTERM):
            raise Interrupted(-status)
        return status, time.monotonic() - begin

    def check_quantities(self):
        """Raises InputError for a quantity that the scene cannot have, such as of a wrong ply. What
        else is wrong with the scene is for its variants to say."""
        errors = self.folder / "variants/check.txt"
        status, _ = self.run(self.plan["goals"], os.devnull, errors, "--validate")
        message = errors.read_text(encoding="utf-8").strip().removeprefix("lamella: ")
        errors.unlink()
        if status == 1 and "Goals/Quantities" in message:
            self.remove_empty_folders()
            raise InputError(re.sub(r"^.*?Goals/Quantities", "Trade/Quantities", message))

    def remove_empty_folders(self):
        """A trade that is refused leaves nothing of its own."""
        (self.folder / "trade.lock").unlink()
        for folder in (self.folder / "variants", self.folder):
            if not any(folder.iterdir()):
                folder.rmdir()

    def failure_of(self, status, errors):
        """Why a run has no results; empty if it has. Status 3: a tolerance is not met."""
        if status in (0, 3):
            return ""
        if status == -signal.SIGXCPU:
            return f"took more than the time limit of {self.plan['time_limit']:g} s."
        if status < 0:
            return (f"was ended by signal {-status}"
                    + (", perhaps because memory ran out." if status == -signal.SIGKILL else "."))
        message = errors.read_text(encoding="utf-8", errors="replace").strip()
        return message.removeprefix("lamella: ") or f"ended with exit status {status}."

    def new_record(self, variant, folder):
        """Runs a variant, a short one several times, and returns its record, in which the costs are
        those of the fastest run."""
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        errors, kept, again = folder / "errors.txt", folder / "run", folder / "again"
        record = {"of": variant["fingerprint"], "seconds": math.inf, "failure": ""}
        # A run to a tolerance is its bars; other variants have them in the first run only.
        has_extra_bars = variant["estimates"] and not variant["theory"].startswith("tolerance")
        for k in range(TRIES):
            target = kept if k == 0 else again
            without_bars = ["Goals/Error bars=false"] if k > 0 and has_extra_bars else []
            status, seconds = self.run(variant["overrides"] + without_bars, folder / "output.txt",
                                       errors, "--output", str(target))
            failure = self.failure_of(status, errors)
            if failure and k == 0:
                return {**record, "seconds": seconds, "failure": failure}
            if failure:
                break
            summary = json.loads((target / "summary.json").read_text(encoding="utf-8"))
            numbers = numbers_of(summary)
            if not has_values(numbers, self.labels):
                return {**record, "seconds": seconds,
                        "failure": "has no value of one of the quantities."}
            if has_extra_bars:
                seconds -= summary.get("seconds_of_error_bars", 0.)
            if k == 0:
                record["numbers"] = numbers
            if seconds < record["seconds"]:
                record["seconds"] = seconds
                record["numbers"]["phases"] = numbers["phases"]
                if not variant["estimates"]:
                    # That of bars is part of it.
                    record["numbers"]["memory"] = numbers["memory"]
                if k > 0 and not variant["estimates"]:
                    shutil.rmtree(kept)
                    again.rename(kept)
            shutil.rmtree(again, ignore_errors=True)
            if record["seconds"] >= SHORT:
                break
        if stamps_of(self.stamps) != self.stamps:
            raise InputError(
                f"{self.plan['scene']}: the scene, a mesh file or the program was changed while "
                "the variants were running. Start the trade again. [trade.scene-changed]")
        return record

    def old_record(self, variant, folder):
        """The record of an earlier trade without a failure, or None: causes of failures (a time
        limit, other programs) may be gone."""
        try:
            record = json.loads((folder / "variant.json").read_text(encoding="utf-8"))
            if (record["of"] == variant["fingerprint"] and record["failure"] == ""
                    and has_values(record["numbers"], self.labels)):
                return record
        except (OSError, ValueError, KeyError, TypeError):
            pass
        return None

    def result_of(self, number, variant):
        """The variant with its record, and prints a line."""
        folder = self.folder / "variants" / folder_name(number, variant["name"])
        begin = f"Variant {number} of {len(self.plan['variants'])}, {variant['name']}: "
        if self.plan["jobs"] == 1:
            print(begin, end="", flush=True)
            begin = ""
        record, note = {"seconds": 0., "failure": variant["failure"]}, ""
        if not variant["failure"]:
            record, note = self.old_record(variant, folder), " (of an earlier trade)"
            if record is None:
                record, note = self.new_record(variant, folder), ""
                path = folder / "variant.json"
                path.with_suffix(".new").write_text(json.dumps(record, indent=2) + "\n",
                                                    encoding="utf-8")
                path.with_suffix(".new").rename(path)
        print(begin + (f"failed: {record['failure']}" if record["failure"] else
                       f"{record['numbers']['dofs']} DoFs, {record['seconds']:.3g} s") + note,
              flush=True)
        return {**variant, **record}

    def results(self):
        """All variants with their records, without those that are the same as another, and the name
        of the reference, or of what stands for it."""
        reference, names, jobs = self.plan["reference"], {}, []
        for number, variant in enumerate(self.plan["variants"], 1):
            same = names.setdefault(variant.get("fingerprint", number), variant["name"])
            if same == variant["name"]:
                jobs.append((number, variant))
                continue
            print(f"Variant {number} of {len(self.plan['variants'])}, {variant['name']}: the same "
                  f"as {same}, left out", flush=True)
            if reference == variant["name"]:
                reference = same
        with ThreadPoolExecutor(self.plan["jobs"]) as pool:
            running = [pool.submit(self.result_of, *job) for job in jobs]
            try:
                return [one.result() for one in running], reference
            except BaseException:
                self.interrupted = True
                for one in running:
                    one.cancel()
                for child in list(self.children):
                    child.kill()
                raise

    def trade(self):
        """The content of trade.json."""
        results, reference = self.results()
        quantities = list(self.plan["quantities"])
        numbers = [one["numbers"] for one in results if not one["failure"]]
        if numbers:
            for probe in self.plan["probes"]:
                quantities += [{"label": label, "given": None}
                               for label in largest_at(probe, numbers[-1]["probes"][probe])]
        places = {one["name"]: k for k, one in enumerate(results)}
        names = [variant["name"] for variant in self.plan["variants"]]
        variants = []
        for one in results:
            own = one.get("numbers", {})
            bars = own.get("bars", {})
            variants.append({
                **{key: one[key] for key in ("name", "theory", "is_solid", "failure", "seconds",
                                             "axis", "section", "overridden")},
                **{key: own.get(key, 0.) for key in ("phases", "dofs", "memory", "stiffening")},
                "buckling_factor": own.get("buckling_factor"),
                "holds": [places[names[k]] for k in one["holds"] if names[k] in places],
                "values": [value_of(own, quantity["label"]) for quantity in quantities if own],
                "bars": [found_in(bars, quantity["label"]) for quantity in quantities if bars]})
        return {**{key: self.plan[key] for key in ("title", "remark", "phases", "tolerances")},
                "reference": reference, "variants": variants, "quantities": quantities}


def take_plan(path):
    """The plan that `lamella trade` has written, which is removed."""
    plan = json.loads(path.read_text(encoding="utf-8"))
    path.unlink()
    return plan
