# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What the matrix of parallel runs varies, and what excludes what.

A new model or setting gets its value here; the rows follow. MODELS says which
axes hold what the CFD half registers: the matrix fails when one is missing.
"""

AXES = {
    # ranks of the two halves, and how they share the space
    "cfd": (2, 4, 1),
    "dem": (2, 4, 1),
    "cut": ("spread", "empty", "emptying", "filling"),  # what happens on one of the CFD ranks: see scene.py
    "demCut": ("z", "low", "x"),                        # layers; layers of a box that reaches far down; columns
    # the domain
    "sides": ("wall", "cyclic", "processorCyclic"),     # of x; processorCyclic: the two sides on two ranks
    "ends": ("wall", "outlet"),                         # of z: p has no fixed value; p is 0 at the top
    "mesh": ("square", "skew"),
    # the CFD half's models
    "dragModel": ("ergunWenYu", "ergunWenYuBlended", "SchillerNaumann", "Gidaspow", "DiFelice", "Beetstra",
                  "KochHill", "WenYu", "Ergun", "SyamlalOBrien", "Stokes"),
    "force": ("none", "pressureGradient", "viscous", "buoyancy", "addedMass", "saffmanMei", "magnus", "torque", "all"),
    "voidFractionModel": ("exactOverlap", "centre", "divided"),
    "smoothingModel": ("none", "diffusion"),
    "selfDisturbance": ("none", "latticeMemory"),
    "model": ("A", "B"),
    "ddtVoidFraction": ("auto", "difference", "particleFlux", "none"),
    "interpolation": ("mapped", "cell", "cellPoint"),
    "overlap": ("yes", "no"),
    "frozenFluid": ("no", "yes"),
    "keepMapping": ("1e-12", "0", "0.01"),
    "quietFluid": ("1e-4", "0"),
    # the CFD half's numerics
    "outer": (1, 3),                                    # nOuterCorrectors
    "momentumPredictor": ("yes", "no"),
    "laplacian": ("corrected", "uncorrected", "orthogonal", "limited 0.5"),
    "gradient": ("Gauss linear", "leastSquares"),
    "pressureSolver": ("DIC", "keptFactor", "GAMG"),
    "steps": (1, 3),                                    # of the fluid in an interval
    # the DEM half
    "bodies": ("spheres", "clumps", "resistance", "both"),
    "lag": (0, 3),                                      # of 10 steps
    "thermal": ("no", "yes"),                           # fix brownian
    "films": ("no", "yes"),                             # fix lubrication
    "charges": ("no", "yes"),                           # pair coul/clump
    "shown": ("no", "yes"),                             # f_ID[k] of fix couple/foam in a dump
}

# axes whose values are names the CFD half knows; "force": each of forceModels
MODELS = {"dragModel": "dragModel", "voidFractionModel": "voidFractionModel", "smoothingModel": "smoothingModel",
          "selfDisturbance": "selfDisturbance", "model": "model", "ddtVoidFraction": "ddtVoidFraction",
          "interpolation": "interpolation", "force": "forceModels"}
# values of "force" that are no model's name
NOT_A_FORCE = ("none", "all")


def _each(row, **wanted):
    """Whether all of these axes are set, each to one of its values."""
    return all(axis in row and row[axis] in values for axis, values in wanted.items())


# what is not asked for because it cannot be: (reason, whether a row or a part of one is such)
EXCLUDED = (
    ("one rank of each is what all others are compared with", lambda r: _each(r, cfd=(1,), dem=(1,))),
    ("one rank holds all cells", lambda r: _each(r, cfd=(1,), cut=("empty", "emptying", "filling"))
     or _each(r, cfd=(1,), sides=("processorCyclic",))),
    ("one DEM rank holds the whole box", lambda r: _each(r, dem=(1,), demCut=("low", "x"))),
)


# what the program must refuse, on any ranks: (words of its reason, whether a row or a part of one is such, such parts)
REFUSED = (
    ("model is B, whose drag carries it", lambda r: _each(r, model=("B",), force=("pressureGradient", "viscous")),
     ({"model": "B", "force": "pressureGradient"}, {"model": "B", "force": "viscous"})),
    ("particles do not disturb a frozen fluid",
     lambda r: _each(r, frozenFluid=("yes",), selfDisturbance=("latticeMemory",)),
     ({"frozenFluid": "yes", "selfDisturbance": "latticeMemory"},)),
    ("the two sides of a cyclic patch lie on different ranks",
     lambda r: _each(r, interpolation=("cellPoint",), sides=("processorCyclic",)),
     ({"interpolation": "cellPoint", "sides": "processorCyclic"},)),
)


def allowed(row):
    """Whether these values, of all axes or of some, can stand together."""
    return not any(test(row) for _, test, *_ in (*EXCLUDED, *REFUSED))


def forces(row):
    """forceModels of a row: buoyancy and pressureGradient stand by where they are not the point."""
    if row["force"] == "none":
        return []
    if row["force"] in ("pressureGradient", "buoyancy"):
        return [row["force"]]
    base = ["pressureGradient", "buoyancy"] if row["model"] == "A" else ["buoyancy"]
    if row["force"] == "all":
        return base + [f for f in AXES["force"] if f not in (*NOT_A_FORCE, *base, "pressureGradient")
                       and not (f == "viscous" and row["model"] == "B")]
    return base + [row["force"]]


def refusal(row):
    """A word of the reason with which a row must be refused; None if it must run."""
    return next((words for words, test, _ in REFUSED if test(row)), None)


def refused_rows():
    """Rows that the program must refuse, on two ranks of each half."""
    plain = {axis: values[0] for axis, values in AXES.items()}
    return [{**plain, "cfd": 2, "dem": 2, **part} for _, _, parts in REFUSED for part in parts]


# axes that must not show in the answer: rows that differ in these alone share a reference
RANKS = ("cfd", "dem", "cut", "demCut")


def reference_of(row):
    """The row on one rank each. What is one rank's is cyclic to it."""
    sides = "cyclic" if row["sides"] == "processorCyclic" else row["sides"]
    return {**row, "cfd": 1, "dem": 1, "cut": "spread", "demCut": "z", "sides": sides}
