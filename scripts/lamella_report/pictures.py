# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a run: drawn by scripts/plot where they are missing, each shown once."""

import base64
import os
import subprocess
from pathlib import Path

from .folder import content_of

MOST_SECONDS = 600.  # a picture takes one or two


def data_uri(kind, content):
    """Bytes as a URI of their own, `data:TYPE;base64,...`."""
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def names_of_pictures(folder):
    """Of DIR/pictures/*.png without the ending, in alphabetical order."""
    path = f"{folder}/pictures"
    names = os.listdir(path) if os.path.isdir(path) else ()
    return sorted(name.removesuffix(".png") for name in names if name.endswith(".png"))


def are_up_to_date(folder):
    """Whether there are pictures, all of them of the run that left the summary: one that
    went on with --resume has an older run's."""
    written = os.stat(f"{folder}/summary.json").st_mtime_ns
    names = names_of_pictures(folder)
    return bool(names) and all(
        os.stat(f"{folder}/pictures/{name}.png").st_mtime_ns >= written for name in names)


def draw_missing(folder):
    """Has scripts/plot draw what a run left, unless the pictures there are younger than its
    summary. Returns why there are none and which command draws them, if so: a page without
    pictures is a page."""
    if are_up_to_date(folder):
        return ""
    plot = Path(__file__).resolve().parents[1] / "plot"
    if not plot.is_file():
        return ("There are no pictures: the script that draws them is not installed with this "
                "program. In the program's source tree, scripts/plot "
                f"{folder} draws them; then make the report again.")
    reason = ""
    try:
        done = subprocess.run([plot, folder], stdin=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              stdout=subprocess.DEVNULL, text=True, errors="replace",
                              timeout=MOST_SECONDS)
        if done.returncode != 0:
            last = done.stderr.strip().rpartition("\n")[2]
            reason = f"exit status {done.returncode}: {last}"
    except (OSError, subprocess.TimeoutExpired) as error:
        reason = str(error)
    return reason and (f"The pictures could not be drawn ({reason}). Once that is mended, {plot} "
                       f"{folder} draws them; then make the report again.")


class Picture:
    def __init__(self, folder, name):
        self.name, self.file = name, f"pictures/{name}.png"
        self.uri = data_uri("image/png", content_of(f"{folder}/{self.file}"))


class Pictures:
    """The pictures of a run, each to be shown once."""

    def __init__(self, folder):
        self.folder, self.left = folder, names_of_pictures(folder)

    def take(self, names):
        self.left = [name for name in self.left if name not in names]
        return [Picture(self.folder, name) for name in names]

    def called(self, name):
        """That of this name, unless it has been shown."""
        return self.take([n for n in self.left if n == name])

    def beginning(self, beginning):
        """Those not shown yet of this name, or whose name goes on after it with an
        underscore."""
        return self.take([n for n in self.left
                          if n == beginning or n.startswith(beginning + "_")])

    def rest(self):
        """All that have not been shown."""
        return self.take(list(self.left))
