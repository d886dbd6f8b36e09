#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the variants of a trade and compares them (doc/guides/convergence-study.md).

Usage: trade.py DIR PLAN (by `lamella trade`, which writes the variants to the file PLAN)

Runs the variants without results (trade_runs.py). Prints the costs of all variants, their errors
with their own bars, and a sentence for each tolerance and quantity; leaves in DIR trade.json (all
numbers), trade.csv, trade.py, which draws trade.png and trade.svg and is meant to be changed to
taste, and these pictures.
"""

import csv
import fcntl
import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

from trade_runs import InputError, Interrupted, NumericsError, Runs, take_plan
from trade_table import NoReference, Table, per_cent, text


def print_table(rows):
    widths = [max(map(len, column)) for column in zip(*rows)]
    for first, *rest, last in rows:
        print("  " + "  ".join([first.ljust(widths[0]),
                                *(cell.rjust(w) for cell, w in zip(rest, widths[1:])), last]))


def table_of_costs(table):
    yield ["variant", "DoFs", "seconds", *table.phases, "MB", ""]
    for variant in table.variants:
        seconds = f"{variant['seconds']:.2f}"
        if variant["failure"]:
            # The first sentence.
            begin, stop, _ = variant["failure"].split("\n")[0].partition(". ")
            yield [variant["name"], "-", seconds, *["-"] * len(table.phases), "-",
                   "failed: " + begin + stop.strip()]
        else:
            yield [variant["name"], str(variant["dofs"]), seconds,
                   *(f"{variant['phases'][phase]:.2f}" for phase in table.phases),
                   f"{variant['memory']:.0f}", ""]


def error_cell(table, k, q):
    error = per_cent(table.error(k, q)) if table.has_error(k, q) else "-"
    own = table.bar(k, q)
    if own is not None:
        return f"{error} (bar {per_cent(own)})"
    return error + (" (no bar)" if table.made_bar(k, q) and table.reference(q) != 0. else "")


def table_of_errors(table):
    quantities = range(len(table.quantities))
    yield ["variant", *(quantity["label"] for quantity in table.quantities), ""]
    for k, variant in enumerate(table.variants):
        yield [variant["name"], *(error_cell(table, k, q) for q in quantities),
               "the reference" if k == table.against else "failed" if variant["failure"] else ""]
    yield ["reference value", *(text(table.reference(q)) for q in quantities), ""]


def print_trade(table):
    print("\nWhat it costs (seconds of the whole process, then by phase; peak memory)\n")
    print_table(list(table_of_costs(table)))
    print("\nHow far it is off\n")
    print_table(list(table_of_errors(table)))
    print("\n" + table.basis())
    for said in (table.beyond_linear(), table.count_of_bars()):
        if said:
            print(said)
    print()
    for tolerance in table.tolerances:
        for q in range(len(table.quantities)):
            print(table.sentence(q, tolerance))


def csv_rows(table):
    """Numbers with 15 digits; a variant that failed has one line, with empty cells and why."""
    def number(value):
        return "" if value is None else text(value, 15)

    yield ["variant", "theory", "dofs", "seconds", *table.phases, "memory_mb", "quantity", "value",
           "reference", "error", "front_seconds", "front_dofs", "bar", "stiffening",
           "buckling_factor", "failure"]
    quantities = range(len(table.quantities))
    fronts = [[table.front(q, cost) for cost in ("seconds", "dofs")] for q in quantities]
    for k, variant in enumerate(table.variants):
        begin = [variant["name"], variant["theory"]]
        if variant["failure"]:
            yield [*begin, "", number(variant["seconds"]), *[""] * len(table.phases), *[""] * 10,
                   variant["failure"].replace("\n", " ")]
            continue
        begin += [variant["dofs"], number(variant["seconds"]),
                  *(number(variant["phases"][phase]) for phase in table.phases),
                  number(variant["memory"])]
        for q in quantities:
            yield [*begin, table.quantities[q]["label"], number(variant["values"][q]),
                   number(table.reference(q)),
                   number(table.error(k, q) if table.has_error(k, q) else None),
                   *(int(k in front) for front in fronts[q]), number(table.bar(k, q)),
                   number(variant["stiffening"]), number(variant["buckling_factor"]), ""]


def draw(table, title, folder):
    """Leaves trade.py in the folder and runs it; returns why there are no pictures, if so."""
    script, log = folder / "trade.py", folder / "trade.log"
    template = (Path(__file__).resolve().parent / "trade_picture.py").read_text()
    script.write_text(
        template.replace('TITLE = ""', "TITLE = " + json.dumps(title), 1)
        .replace("TOLERANCES = []",
                 "TOLERANCES = " + json.dumps([100. * one for one in table.tolerances]), 1))
    for python in dict.fromkeys((sys.executable, "/usr/bin/python3", shutil.which("python3"))):
        if python and subprocess.run([python, "-c", "import matplotlib"],
                                     stderr=subprocess.DEVNULL, check=False).returncode == 0:
            with open(log, "w", encoding="utf-8") as errors:
                done = subprocess.run([python, str(script)], stdout=subprocess.DEVNULL,
                                      stderr=errors, check=False)
            if done.returncode:
                return f"{script} failed, see {log}"
            log.unlink()
            return ""
    return ("there is no python3 with matplotlib to draw them with: apt-get install "
            f"python3-matplotlib, and run {script}")


def make_tables(trade, folder):
    """Tables, sentences and pictures of the numbers."""
    try:
        table = Table(trade)
    except NoReference as none:
        raise NumericsError("The reference solution of the trade is missing, so there are no "
                            f"errors. Cause: {none} [trade.no-reference]") from none
    with open(folder / "trade.csv", "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows(csv_rows(table))
    print_trade(table)
    print(trade["remark"], end="")
    no_picture = draw(table, trade["title"], folder)
    if no_picture:
        print(f"\nNo pictures: {no_picture}.", end="")
    print(f"\nThe trade is in {folder} (trade.csv"
          + ("" if no_picture else ", trade.png, trade.svg") + "; the runs in variants/)")


def run(folder, plan):
    with open(folder / "trade.lock", "a", encoding="utf-8") as lock:
        try:
            fcntl.lockf(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise InputError(f"--output {folder}: another trade writes into this folder. Wait until "
                             "it ends, or name another folder. [trade.folder-in-use]") from error
        # Those of an earlier trade would look like this one's.
        for name in ("trade.json", "trade.csv", "trade.py", "trade.png", "trade.svg"):
            (folder / name).unlink(missing_ok=True)
        runs = Runs(plan, folder)
        runs.check_quantities()
        trade = runs.trade()
        (folder / "trade.json").write_text(json.dumps(trade, indent=1) + "\n", encoding="utf-8")
        make_tables(trade, folder)


def end_by(signal_number, folder):
    """Ends this process by the signal, as a shell expects, with what stands in the folder."""
    print(f"lamella: interrupted. {folder}/variants has the variants before this one. The same "
          "command goes on with it.", file=sys.stderr, flush=True)
    signal.signal(signal_number, signal.SIG_DFL)
    os.kill(os.getpid(), signal_number)


def main():
    def stop(number, _):
        raise Interrupted(number)

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, stop)
    folder = Path(sys.argv[1])
    try:
        run(folder, take_plan(Path(sys.argv[2])))
    except InputError as error:
        print(f"lamella: {error}", file=sys.stderr)
        return 1
    except NumericsError as error:
        print(f"lamella: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:
        # Whoever reads the output has enough of it.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except OSError as error:
        print(f"lamella: cannot write {error.filename}. Check that the disk is not full. "
              "[base.cannot-write]", file=sys.stderr)
        return 1
    except Interrupted as signalled:
        end_by(signalled.number, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
