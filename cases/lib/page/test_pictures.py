# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What stands on the pictures of a run."""

import numpy as np
import pytest

from cases.lib.calibration import stages_main
from cases.lib.output import pictures
from cases.lib.output.plotting import mpl, plt
from cases.lib.run import beds


@pytest.fixture
def drawn(monkeypatch):
    """The figures that were drawn, which are not closed."""
    found = []
    plt.figure()  # the backend is chosen at the first, which closes all
    plt.close("all")
    monkeypatch.setattr(plt, "close", found.append)
    yield found
    monkeypatch.undo()
    plt.close("all")


def words(fig):
    return " ".join(t.get_text() for t in fig.findobj(mpl.text.Text))


CURVE = {"time_s": np.linspace(0, 2, 40), "interface_m": np.linspace(0.15, 0.05, 40),
         "mean_height_m": np.linspace(0.07, 0.03, 40)}


@pytest.mark.parametrize("scale", [None, 9.49e5])
def test_days_only_with_a_time_scale(drawn, tmp_path, scale):
    pictures.settling(str(tmp_path), CURVE, scale, "a title of the settings")
    fig = drawn[0]
    fig.canvas.draw()
    assert ("days" in words(fig)) == bool(scale)
    assert "a title of the settings" in words(fig) and "height [mm]" in words(fig)
    assert max(line.get_ydata().max() for line in fig.axes[0].lines) == pytest.approx(150)


def test_long_titles_are_broken(drawn, tmp_path):
    pictures.settling(str(tmp_path), CURVE, None, "a clump-half with very many settings that are otherwise = 1, " * 4)
    fig = drawn[0]
    fig.canvas.draw()
    box = fig.axes[0].title.get_window_extent()
    assert 0 < box.x0 and box.x1 < fig.bbox.x1 and box.y1 < fig.bbox.y1


def test_stages_in_millimetres(drawn, tmp_path):
    args = stages_main.parser().parse_args(["x", "--samples", "20"])
    t, z = CURVE["time_s"], CURVE["interface_m"]
    fit, _ = stages_main.find(t, z, args)
    stages_main.draw(str(tmp_path / "a.png"), t, z, fit, ["time_s", "interface_m"], "a title")
    said = words(drawn[0])
    assert "[mm]" in said and "[m]" not in said and "-50 mm/s" in said
    stages_main.draw(str(tmp_path / "a.png"), t, 100 * z, fit, ["time_s", "height_cm"], "a title")
    assert "[cm]" in words(drawn[1])  # the unit of the file


def test_a_bed_that_ended_before_its_ramp(tmp_path):
    out = tmp_path / "CFD" / "postProcessing" / "inlet" / "0"
    out.mkdir(parents=True)
    (out / "surfaceFieldValue.dat").write_text("# t p U\n0.01 0.1 (0 0 0.002)\n0.02 0.1 (0 0 0.002)\n")
    v = {"sphere_radius": 5e-4, "fluid_density": 10.0, "viscosity": 1.5e-3, "spheres": 1000, "density": 2000.0,
         "gravity": 9.81, "size_x": 0.01, "size_y": 0.01, "hold": 0.05}
    said = dict(beds.finish(str(tmp_path), v, CURVE, "a title"))
    assert said["bed height"].endswith("the ramp was not reached")
    assert (tmp_path / "bed.json").is_file() and not (tmp_path / "bed.png").exists()


def test_beds_in_millimetres(drawn, tmp_path):
    u = np.linspace(0.002, 0.02, 50)
    v = {"sphere_radius": 5e-4, "fluid_density": 10.0, "viscosity": 1.5e-3}
    found = {"buoyant_weight_Pa": 100.0, "height_at_rest_m": 0.01, "porosity_at_rest": 0.4, "u_mf_m_per_s": 0.01}
    beds._draw(str(tmp_path / "bed.png"), v, (u, 1e4 * u, 0.01 + 0 * u), found, "a title")
    over, low = drawn[0].axes
    assert low.get_xlabel() == "superficial velocity [mm/s]"
    drop, law = over.lines[0], over.lines[2]
    assert drop.get_xdata()[-1] == pytest.approx(20)
    at = law.get_xdata() > 0  # Ergun's drop at the velocity that stands below it
    assert law.get_ydata()[at] == pytest.approx(beds.ergun(v, 0.4, 0.01, 1e-3 * law.get_xdata()[at]))
    assert [line.get_xdata()[0] for line in low.lines if len(line.get_xdata()) == 2] == [pytest.approx(10)]
