# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""report.html: what stands on it, and that a browser shows it."""

import html.parser
import json
import os
import re
import shutil
import subprocess

import numpy as np
import pytest

from cases.lib.case import settings
from cases.lib.case.casefile import Case
from cases.lib.page import page, page_pictures
from cases.lib.run import folders

_DUMP = "ITEM: NUMBER OF ATOMS\n{n}\nITEM: ATOMS id mol type x y z vx vy vz radius \n{rows}"


class Reader(html.parser.HTMLParser):
    """The words of a page, its pictures, and what it would fetch."""

    def __init__(self, text):
        super().__init__()
        self.words, self.images, self.fetched = "", [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if tag == "img":
            self.images.append(attrs["src"])
        self.fetched += [v for k, v in attrs.items() if k in ("src", "href", "data") and not v.startswith("data:")]

    def handle_data(self, data):
        self.words += " ".join(data.split()) + " "


@pytest.fixture
def run(tmp_path):
    """The folder of a run that was made up: its case, what follows, its summary."""
    def make(name="sphere-half", *words, **more):
        case = Case(name)
        settings.apply(case, settings.read(["end=1", *words]))
        derived = case.derive(1, 1)
        folders.write_mark(str(tmp_path), case, (1, 1))
        (tmp_path / "DEM").mkdir(exist_ok=True)
        t = np.linspace(0, 1, 60)
        top = np.maximum(0.15 - 0.3 * t, 0.04 - 0.02 * t)
        (tmp_path / "settling.csv").write_text("time_s,interface_m,bed_m,mean_height_m\n" + "".join(
            f"{a:.6g},{b:.6g},0,{0.5 * b:.6g}\n" for a, b in zip(t, top)))
        for step in (0, 10000):
            rows = "".join(f"{i + 1} {i + 1} 1 0 0 {0.02 * i + 0.01:.4g} 0 0 0 0.001 \n" for i in range(5))
            (tmp_path / "DEM" / f"spheres.{step:09d}.dump").write_text(_DUMP.format(n=5, rows=rows))
        summary = {"complete": True, "simulated_s": 1.0, "end": 1.0,
                   "versions": {"clayFoam": "0", "dem": "L", "cfd": None},
                   "warnings": ["a < b"], "wall_s": 2.0, "dem_alone_s": None, "particles": 5, "particles_lost": 0,
                   "max_overlap_over_d": 0.01, **more}
        for key in ("dem_s", "waiting_dem_s", "cfd_s", "mapping_s", "waiting_cfd_s", "exchange_dem_s",
                    "exchange_cfd_s", "coupled_over_dem", "max_momentum_residual", "max_void_fraction_volume_error",
                    "reynolds_max",
                    "courant_max"):
            summary.setdefault(key, 0.5)
        with open(page.write(str(tmp_path), case, derived, summary), encoding="utf-8") as f:
            return f.read()
    return make


def test_what_stands_on_the_page(run):
    text = run("sphere-half", "density=2000", "layers=20")
    read = Reader(text)
    assert read.fetched == []  # one file
    assert len(read.images) == 2 and all(i.startswith("data:image/png;base64,") for i in read.images)
    for words in ("sphere-half with density = 2000 kg/m3, layers = 20", "Complete: 1 s simulated", "a < b",
                  "Kynch's theory", "Stages of the upper interface", "Solid fraction over height",
                  "particles 5, lost 0",
                  "layers 18 20", "density 2600 2000 kg/m3", "2.0 s for 1 s simulated"):
        assert words in read.words, words
    assert "-300" in read.words  # of the first stage, mm/s
    assert " solids " not in Reader(run("sphere-half", "spheres=100")).words


def test_a_run_that_is_not_complete(run):
    read = Reader(run("clump-half", complete=False, simulated_s=0.25, reason="it was ended <b>"))
    assert "Not complete: 0.25 s of 1 s; it was ended <b>" in read.words
    assert "Kynch" not in read.words  # no theory of charged clumps


def test_solid_fractions_of_layers():
    v = {"tube_radius": 0.01, "tube_height": 0.1, "sphere_radius": 1e-3}
    s = {"z": np.array([0.001, 0.002, 0.051]), "radius": np.full(3, 1e-3)}
    z, phi = page_pictures.solid_fraction(s, v)
    volume = np.sum(phi * np.pi * 0.01**2 * (z[1] - z[0]))
    assert volume == pytest.approx(3 * 4 / 3 * np.pi * 1e-9)
    assert np.count_nonzero(phi) == 2 and phi[0] == pytest.approx(2 * phi[phi > 0][-1])


@pytest.mark.long
def test_a_browser_shows_it(run, tmp_path):
    browser = shutil.which("chromium")
    if not browser:
        pytest.skip("chromium is not installed")
    text = run("sphere-half", "density=2000")
    measure = ("<script>onload = () => { document.title = JSON.stringify({images: [...document.images].filter("
               "i => i.naturalWidth > 300).length, wide: document.documentElement.scrollWidth - innerWidth, "
               "high: document.documentElement.scrollHeight, words: document.body.innerText.length}) }</script>")
    path = tmp_path / "measured.html"
    path.write_text(text.replace("</html>", measure + "</html>"))
    words = [browser, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path / 'browser'}",
             "--window-size=1000,1400"]
    said = subprocess.run([*words, "--dump-dom", path.as_uri()], text=True, capture_output=True, check=True,
                          timeout=180).stdout
    found = json.loads(re.search(r"<title>(.*?)</title>", said).group(1).replace("&amp;", "&"))
    assert found["images"] == 2 and found["wide"] <= 0
    assert found["high"] > 1000 and found["words"] > 800
    picture = tmp_path / "page.png"
    subprocess.run([*words, f"--screenshot={picture}", path.as_uri()], capture_output=True, check=True, timeout=180)
    from cases.lib.output.plotting import plt
    image = plt.imread(picture)[..., :3]
    assert image.shape[:2] == (1400, 1000) and image.std() > 0.02 and image.mean() > 0.5  # white, with something on it
    assert os.path.getsize(picture) > 20000
