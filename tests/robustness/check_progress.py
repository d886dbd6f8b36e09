#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a scene on a terminal and through a pipe and reads what it says of its progress.

Usage: check_progress.py LAMELLA SCENE.prm WORKDIR

On a terminal, after three seconds, the last line says the load step, the share that is done
and the time that is left; it is overwritten by the next one and erased before anything else
is said, so that of all of them only the last one is there when Ctrl-C ends the run. Behind
other programs of a terminal, and through a pipe, there is none.
"""

import os
import pty
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

STEPS, PATIENCE = 4000, 120.
LINE = re.compile(r"\r  (load step \d+ of \d+), (\d+) %, (about \d+ (s|min) left|\d+ s so far)")
faults = []


def expect(truth, what):
    print(("ok    " if truth else "FAIL  ") + what)
    if not truth:
        faults.append(what)


def shown(text):
    """What a terminal shows of @p text, its last line last; a return goes back in a line."""
    lines = []
    for written in text.replace("\r\n", "\n").split("\n"):
        line = ""
        for piece in written.split("\r"):
            line = piece + line[len(piece):]
        lines.append(line.rstrip())
    return lines


def read_until(terminal, enough, seconds):
    """What is written to the terminal until there is enough of it, or the run ends."""
    text, begin = "", time.monotonic()
    while not enough(text) and time.monotonic() - begin < seconds:
        try:
            piece = os.read(terminal, 4096)
        except OSError:  # nobody is left to write
            break
        text += piece.decode()
    return text


def run_on_terminal(words, seen):
    """Starts the run on a terminal of its own; in the background unless @p seen."""
    pid, terminal = pty.fork()
    if pid:
        return pid, terminal
    if not seen:
        # The child, of a group of its own, is not the terminal's foreground.
        child = os.fork()
        if child:
            signal.signal(signal.SIGTERM, lambda *_: os.kill(child, signal.SIGKILL))
            os.waitpid(child, 0)
            os._exit(0)
        os.setpgid(0, 0)
    os.execv(words[0], words)


def check_terminal(words, output):
    begin = time.monotonic()
    pid, terminal = run_on_terminal(words, True)
    first = read_until(terminal, LINE.search, PATIENCE)
    expect(time.monotonic() - begin > 3., "nothing in the first three seconds")
    text = first + read_until(terminal, lambda t: len(LINE.findall(t)) >= 4, PATIENCE)
    os.write(terminal, b"\x03")
    text += read_until(terminal, lambda t: False, PATIENCE)
    _, status = os.waitpid(pid, 0)
    expect(os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGINT, "Ctrl-C ends it")
    said = LINE.findall(text)
    expect(len(said) >= 5, f"it says how far it is: {said[-1:]}")
    shares = [int(share) for _, share, *_ in said]
    expect(shares == sorted(shares), f"what is done does not become less: {shares}")
    expect(any("left" in left for _, _, left, _ in said), "the time that is left")
    lines = shown(text)
    expect(sum(" %" in line for line in lines) <= 1, "one line, which is overwritten")
    steps = [line for line in lines if line.startswith("Load step")]
    expect(all(re.fullmatch(r"Load step \d+ of \d+, load factor \S+", s) for s in steps),
           "other lines are whole")
    expect(f"interrupted. {output} has load steps 1 to " in text, lines[-2])


def check_background(words):
    pid, terminal = run_on_terminal(words, False)
    text = read_until(terminal, lambda t: "\nLoad step 2 " in t, PATIENCE)
    text += read_until(terminal, lambda t: False, 8.)
    os.kill(pid, signal.SIGTERM)
    os.waitpid(pid, 0)
    os.close(terminal)
    expect("Load step 2 " in text and not LINE.search(text), "behind other programs none")


def check_pipe(words):
    run = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        run.communicate(timeout=10.)
        expect(False, "the run is too short to tell")
    except subprocess.TimeoutExpired:
        run.send_signal(signal.SIGINT)
        said, _ = run.communicate()
        expect(b"\r" not in said and b" %" not in said, "through a pipe none")


def main():
    program, scene = sys.argv[1:3]
    folder = Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    words = [program, scene, "--output", str(folder), "--set", "Load factors=" +
             ", ".join(str((k + 1) / STEPS) for k in range(STEPS))]
    check_terminal(words, folder)
    check_background(words)
    check_pipe(words)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
