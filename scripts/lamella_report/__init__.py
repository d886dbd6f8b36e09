# SPDX-License-Identifier: LGPL-2.1-or-later
"""`lamella report DIR`: what a run has left in a folder as one page of HTML.

The page is made from the folder's files and nothing else; it never solves anything.
folder.py reads them, scene.py the scene among them, chapters.py finds what is worth
telling, formats.py writes numbers and formulas, pictures.py has pictures drawn and shows
each once, and page.py fills the templates: templates/page.html is the whole, and a
template of the name of each chapter has its words.
"""
