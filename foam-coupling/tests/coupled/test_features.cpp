// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// What a case brings of OpenFOAM's own: fvOptions, turbulence models, boundary
// conditions; each against a known value.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

#include "coupledRun.h"

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double rhoF = 1000;

/// A square duct along z, cells of that size [m], in which every cell of the
/// lowest ones holds one sphere that nothing moves. Fluid comes in below.
struct HeldBed {
  double cell = 0.01, solid = 0.4, U0 = 1, nu = 1e-6;
  int high = 12, filled = 12;

  double d() const { return cell * std::cbrt(6 * solid / pi); }

  CoupledRun run(const std::string& name) const {
    CoupledRun run(name);
    std::ostringstream entries, hi, to, count;
    entries << "x1 " << 2 * cell << "; y1 " << 2 * cell << "; z1 " << high * cell
            << "; nx 2; ny 2; nz " << high << "; sideType patch; bottomType patch; topType patch;"
            << "sideU slip; bottomU fixedValue; topU zeroGradient; topP fixedValue; nu " << nu
            << "; U0 (0 0 " << U0 << ");";
    hi << 2 * cell << "," << 2 * cell << "," << high * cell;
    to << 2 * cell << "," << 2 * cell << "," << filled * cell;
    count << "2,2," << filled;
    run.box(entries.str());
    run.edit("0/U", "{ type $bottomU; }", "{ type $bottomU; value uniform $U0; }");
    run.dem("hi", hi.str()).dem("to", to.str()).dem("count", count.str());
    run.dem("radius", d() / 2).dem("frozen", 1).dem("step", 1e-4).dem("interval", 20);
    return run;
  }
};

/// Writes a scalar field of the start: this value inside and on the inlet.
void scalarField(const CoupledRun& run, const std::string& name, const std::string& dims,
                 double value) {
  std::ofstream(run.path() / "0" / name)
      << "FoamFile { version 2.0; format ascii; class volScalarField; object " << name << "; }\n"
      << "dimensions " << dims << ";\ninternalField uniform " << value << ";\n"
      << "boundaryField\n{\n    \"(left|right|front|back|top)\" { type zeroGradient; }\n"
      << "    bottom { type fixedValue; value uniform " << value << "; }\n}\n";
}

/// Names the turbulence model; convection of its fields is upwind.
void turbulence(CoupledRun& run, const std::string& kind, const std::string& model) {
  run.edit("constant/turbulenceProperties", "simulationType  laminar;",
           "simulationType " + kind + ";\n" + kind + " { " + kind + "Model " + model +
               "; turbulence on; printCoeffs off; delta cubeRootVol; cubeRootVolCoeffs {} }");
  run.edit("system/fvSchemes", "default                         none;",
           "default none; div(phi,k) Gauss upwind; div(phi,epsilon) Gauss upwind;"
           "div(phi,omega) Gauss upwind;");
  run.edit("system/fvSchemes", "snGradSchemes ", "wallDist { method meshWave; }\nsnGradSchemes ");
  run.edit("system/fvSolution", "(U|UFinal)", "(U|k|epsilon|omega)(Final)?");
}

/// One row of cells of the stream in the bed.
struct Row {
  double k, second;  ///< second: epsilon or omega
};

/// The rows of cells of a held bed, from the balances of k and epsilon (or omega) over each
/// cell: n phi (k - kBelow) = n V (G - 2/3 k div U - eps). phi grows in the first cell alone;
/// G follows from the cells' own U. rates(row, div U, G/nut) returns the two right-hand sides
/// by k and by the second.
template <class Rates>
std::vector<Row> rows(const HeldBed& bed, const CoupledRun& run, Row in, Rates rates) {
  const auto U = run.values("U");
  const auto face = [&](int below) {  // U on the face above that row
    if (below < 0) return bed.U0;
    const auto b = static_cast<std::size_t>(4 * below);
    return below + 1 < bed.high ? 0.5 * (U[b][2] + U[b + 4][2]) : U[b][2];
  };
  const double n = 1 - bed.solid, stay = n * bed.cell / bed.U0;  // time in a cell [s]
  std::vector<Row> all;
  for (int i = 0; i < bed.high; ++i) {
    const double divU = i == 0 ? (1 / n - 1) * bed.U0 / bed.cell : 0;
    const double slope = (face(i) - face(i - 1)) / bed.cell;
    Row here = in;
    for (int j = 0; j < 2000; ++j) {
      const auto [byK, bySecond] = rates(here, divU, 4 / 3. * slope * slope);
      here.k = 0.5 * here.k + 0.5 * in.k / (1 - stay * byK);
      here.second = 0.5 * here.second + 0.5 * in.second / (1 - stay * bySecond);
    }
    all.push_back(here);
    in = here;
  }
  return all;
}

void expectRows(const CoupledRun& run, const std::string& second, const std::vector<Row>& rows) {
  const auto k = run.scalars("k"), other = run.scalars(second);
  ASSERT_EQ(k.size(), 4 * rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(k[4 * i] / rows[i].k, 1, 2e-3) << "k of row " << i;
    EXPECT_NEAR(other[4 * i] / rows[i].second, 1, 2e-3) << second << " of row " << i;
  }
}

}  // namespace

// A body force of the fluid stands in p, and acts on the spheres like the buoyancy of a fluid
// with that weight. By the fluid's volume: else it would be off by n
TEST(FvOptions, ActByTheFluidsVolume) {
  const double d = 2e-3, mu = 1, solid = 0.1, n = 1 - solid, S = 15;
  const int across = 4, high = 40;
  const double a = d * std::cbrt(pi / 6 / solid), width = across * a, height = (high + 4) * a;
  CoupledRun run("fvoptions");
  std::ostringstream entries, lo, hi, from, to;
  for (auto* os : {&entries, &hi, &from, &to}) os->precision(17);
  entries << "x1 " << width << "; y1 " << width << "; z1 " << height
          << "; nx 1; ny 1; nz 20; sideU slip; nu " << mu / rhoF << ";";
  hi << width << "," << width << "," << height;
  from << "0,0," << 2 * a;
  to << width << "," << width << "," << (high + 2) * a;
  run.box(entries.str());
  run.dem("hi", hi.str()).dem("from", from.str()).dem("to", to.str());
  run.dem("count", "4,4,40").dem("stagger", 1).dem("radius", d / 2).dem("steps", 2000);
  run.dem("zlo", (2 + 0.25 * high) * a).dem("zhi", (2 + 0.75 * high) * a);
  run.properties("forceModels (pressureGradient);");
  std::ofstream(run.path() / "system" / "fvOptions")
      << "FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }\n"
      << "lift { type vectorSemiImplicitSource; active yes; selectionMode all;\n"
      << "  volumeMode specific; injectionRateSuSp { U ((0 0 " << S << ") 0); } }\n";
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();

  // Stokes regime: v = n rhoF S d^2/(18 mu) n^3.7, downwards
  const double stokes = rhoF * S * d * d / (18 * mu) * std::pow(n, 3.7);
  double slip = stokes;
  for (int i = 0; i < 300; ++i)
    slip = 0.5 * slip + 0.5 * stokes / (1 + 0.15 * std::pow(n * rhoF * slip * d / mu, 0.687));
  const auto history = run.history();
  double mean = 0;
  const std::size_t half = history.size() / 2;
  for (std::size_t i = half; i < history.size(); ++i)
    mean += history[i]["velocity"][2].get<double>() / static_cast<double>(history.size() - half);
  EXPECT_NEAR(-mean / (n * slip), 1, 2e-3);
  EXPECT_LT(run.cfd()["max_momentum_residual"], 1e-10);
  // it ends at the floor and at the top, and runs along the sides
  const std::string warnings = run.cfd()["warnings"].dump();
  EXPECT_EQ(run.cfd()["warnings"].size(), 2u) << warnings;
  for (const char* patch : {"'bottom'", "'top'"})
    EXPECT_NE(warnings.find(std::string("pushes with 15 m/s2 against patch ") + patch),
              std::string::npos)
        << warnings;
}

TEST(Turbulence, KEpsilonOfTheFluidInABed) {
  const HeldBed bed;
  auto run = bed.run("kEpsilon");
  turbulence(run, "RAS", "kEpsilon");
  const Row in{1e-5, 2e-4};
  scalarField(run, "k", "[0 2 -2 0 0 0 0]", in.k);
  scalarField(run, "epsilon", "[0 2 -3 0 0 0 0]", in.second);
  scalarField(run, "nut", "[0 2 -1 0 0 0 0]", 0.09 * in.k * in.k / in.second);
  run.properties("dragModel Stokes;").dem("steps", 6000);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  expectRows(
      run, "epsilon", rows(bed, run, in, [](const Row& r, double divU, double GbyNu) {
        const double C1 = 1.44, C2 = 1.92, time = r.k / r.second, G = 0.09 * time * GbyNu;
        return std::pair{G - 2 / 3. * divU - 1 / time, C1 * G - 2 / 3. * C1 * divU - C2 / time};
      }));
}

TEST(Turbulence, KOmegaSSTOfTheFluidInABed) {
  const HeldBed bed;
  auto run = bed.run("kOmegaSST");
  turbulence(run, "RAS", "kOmegaSST");
  const Row in{1e-6, 200};
  scalarField(run, "k", "[0 2 -2 0 0 0 0]", in.k);
  scalarField(run, "omega", "[0 0 -1 0 0 0 0]", in.second);
  scalarField(run, "nut", "[0 2 -1 0 0 0 0]", in.k / in.second);
  run.properties("dragModel Stokes;").dem("steps", 6000);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  expectRows(run, "omega", rows(bed, run, in, [](const Row& r, double divU, double GbyNu) {
               const double betaStar = 0.09, beta2 = 0.0828, gamma2 = 0.44, w = r.second;
               return std::pair{GbyNu / w - 2 / 3. * divU - betaStar * w,
                                gamma2 * GbyNu / w - 2 / 3. * gamma2 * divU - beta2 * w};
             }));
}

// nut of a shear flow, and the stress that goes with it
TEST(Turbulence, SmagorinskyInAShearFlow) {
  CoupledRun run("Smagorinsky");
  const double H = 0.08;
  run.box(
      "x1 0.02; y1 0.02; z1 0.08; nx 2; ny 2; nz 8; sideType cyclic; sideU cyclic;"
      "sideP cyclic; bottomType wall; topType wall; bottomU noSlip; topU fixedValue; nu 4e-3;");
  run.edit("0/U", "{ type $topU; }", "{ type $topU; value uniform (1 0 0); }");
  turbulence(run, "LES", "Smagorinsky");
  std::ofstream(run.path() / "0" / "nut")
      << "FoamFile { version 2.0; format ascii; class volScalarField; object nut; }\n"
      << "dimensions [0 2 -1 0 0 0 0];\ninternalField uniform 0;\nboundaryField\n{\n"
      << "    \"(left|right|front|back)\" { type cyclic; }\n"
      << "    \"(bottom|top)\" { type zeroGradient; }\n}\n";
  run.properties("dragModel Stokes;").dem("hi", "0.02,0.02,0.08").dem("from", "0.009,0.009,0.04");
  run.dem("to", "0.01,0.01,0.041")
      .dem("frozen", 1)
      .dem("radius", 1e-8)
      .dem("step", 1e-3)
      .dem("steps", 4000);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();

  const double Ck = 0.094, Ce = 1.048, delta = 0.01, slope = 1 / H;
  const auto nut = run.scalars("nut");
  const auto U = run.values("U");
  for (std::size_t row = 1; row < 7; ++row) {
    EXPECT_NEAR(U[4 * row][0], (static_cast<double>(row) + 0.5) / 8, 1e-4);
    EXPECT_NEAR(nut[4 * row] / (Ck * std::sqrt(Ck / Ce) * delta * delta * slope), 1, 1e-3);
  }
}

namespace {

/// Drop of p [m2/s2] over each row of cells of a bed that lies on the inlet, by Ergun's law.
std::vector<double> ergunDrops(const HeldBed& bed, const CoupledRun& run) {
  const auto n = run.scalars("voidfraction");
  std::vector<double> drops;
  for (std::size_t row = 0; row < 12; ++row) {
    const double e = n[4 * row], s = 1 - e, d = bed.d();
    drops.push_back(bed.cell * (150 * s * s * bed.nu * bed.U0 / (e * e * e * d * d) +
                                1.75 * s * bed.U0 * bed.U0 / (e * e * e * d)));
  }
  return drops;
}

HeldBed bedOnTheInlet() {
  HeldBed bed;
  bed.U0 = 0.01;
  bed.nu = 1e-3;
  bed.filled = 5;
  return bed;
}

}  // namespace

TEST(FixedFluxPressure, CarriesTheForceOfABedToTheInlet) {
  const HeldBed bed = bedOnTheInlet();
  auto run = bed.run("inlet");
  run.box("bottomP fixedFluxPressure;");
  run.edit("0/p", "{ type $bottomP; }", "{ type $bottomP; value uniform 0; }");
  run.properties("dragModel Ergun;").dem("steps", 6000);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();

  const auto drops = ergunDrops(bed, run);
  const double p = std::accumulate(drops.begin(), drops.end(), 0.0);
  EXPECT_NEAR(run.scalars("voidfraction")[0], 0.6, 1e-6);
  // U is the superficial velocity there
  EXPECT_EQ(run.onPatch("voidfraction", "bottom"), 1);
  EXPECT_NEAR(run.onPatch("p", "bottom") / p, 1, 2e-3);
}

// With zeroGradient the inlet has the p of its cell, half of whose drop lies below it
TEST(ZeroGradientPressure, MissesHalfACellOfABedOnTheInlet) {
  const HeldBed bed = bedOnTheInlet();
  auto run = bed.run("inlet-zeroGradient");
  run.properties("dragModel Ergun;").dem("steps", 6000);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();

  const auto drops = ergunDrops(bed, run);
  const double p = std::accumulate(drops.begin(), drops.end(), -drops[0] / 2);
  EXPECT_NEAR(run.scalars("p")[0] / p, 1, 2e-3);
}

// Where no patch fixes p
TEST(PressureReference, IsTheValueOfItsCell) {
  CoupledRun run("p-reference");
  run.box("x1 0.02; y1 0.02; z1 0.04; nx 2; ny 2; nz 4; nu 1e-3;");
  run.edit("system/fvSolution", "pRefCell            0;", "pRefCell 5;");
  run.edit("system/fvSolution", "pRefValue           0;", "pRefValue 7;");
  run.dem("hi", "0.02,0.02,0.04").dem("from", "0,0,0.02").dem("to", "0.02,0.02,0.04");
  run.dem("count", "4,4,4").dem("gravity", "0,0,-9.81").dem("density", 2600).dem("steps", 400);
  run.dem("radius", 5e-4);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  const auto p = run.scalars("p");
  EXPECT_NEAR(p[5], 7, 1e-9);
  EXPECT_GT(std::fabs(p[15] - 7), 1e-4);
}

namespace {

/// One sphere in the middle of a box of fluid that stays at rest; Stokes drag.
CoupledRun single(const std::string& name, const std::string& transport) {
  CoupledRun run(name);
  run.box("x1 0.1; y1 0.1; z1 0.1; nx 5; ny 5; nz 5;");
  run.edit("constant/transportProperties", "transportModel  Newtonian;\nnu              $nu;",
           transport);
  run.properties("dragModel Stokes; frozenFluid yes;");
  run.dem("hi", "0.1,0.1,0.1").dem("from", "0.05,0.05,0.05").dem("to", "0.06,0.06,0.06");
  run.dem("radius", 1e-3).dem("gravity", "0,0,-9.81").dem("density", 2600).dem("steps", 8000);
  return run;
}

constexpr double weight = 1600 * 9.81 * pi / 6 * 8e-9;  // of a sphere of 2 mm in water [N]

}  // namespace

TEST(Viscosity, ANewtonianLimitGivesStokesDrag) {
  auto run = single("bird-carreau",
                    "transportModel BirdCarreau;\n"
                    "BirdCarreauCoeffs { nu0 1e-3; nuInf 1e-3; k 1; n 0.5; }");
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_NEAR(-run.lastVelocity() / (weight / (3 * pi * 1 * 2e-3)), 1, 5e-3);
}

// Below the critical yield number a grain falls by what the yield stress leaves of its weight;
// above it creeps no faster than the largest viscosity lets it
TEST(Viscosity, AYieldStressHoldsAGrainOrLetsItFall) {
  const auto bingham = [](double tau) {
    std::ostringstream os;
    os << "transportModel HerschelBulkley;\nHerschelBulkleyCoeffs { nu0 1; tau0 " << tau / rhoF
       << "; k 1e-3; n 1; }";
    return os.str();
  };
  const double critical = 0.143 * weight / (2 * pi * 1e-6), mu = 1, d = 2e-3;

  auto falls = single("bingham-falls", bingham(0.5 * critical));
  ASSERT_EQ(falls.meshAndRun(), 0) << falls.log();
  EXPECT_NEAR(-falls.lastVelocity() / (0.5 * weight / (3 * pi * mu * d)), 1, 0.02);

  auto creeps = single("bingham-creeps", bingham(1.3 * critical));
  ASSERT_EQ(creeps.meshAndRun(), 0) << creeps.log();
  EXPECT_LE(-creeps.lastVelocity(), 1.01 * weight / (3 * pi * 1000 * d));
  EXPECT_GT(-creeps.lastVelocity(), 0);
}

// Between two walls, driven by a body force G: U = n/(n + 1) (G/k)^(1/n) (h^(1 + 1/n) - z^(1 +
// 1/n))
TEST(Viscosity, APowerLawFluidFlowsByItsProfile) {
  CoupledRun run("power-law");
  const double h = 0.04, n = 0.5, k = 1e-2, G = 0.7;
  run.box(
      "x1 0.02; y1 0.02; z1 0.08; nx 2; ny 2; nz 32; sideType cyclic; sideU cyclic; sideP cyclic;");
  run.edit("constant/transportProperties", "transportModel  Newtonian;\nnu              $nu;",
           "transportModel powerLaw; powerLawCoeffs { k 1e-2; n 0.5; nuMin 1e-6; nuMax 1; }");
  std::ofstream(run.path() / "system" / "fvOptions")
      << "FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }\n"
      << "drive { type vectorSemiImplicitSource; active yes; selectionMode all;\n"
      << "  volumeMode specific; injectionRateSuSp { U ((" << G << " 0 0) 0); } }\n";
  run.properties("dragModel Stokes;").dem("hi", "0.02,0.02,0.08").dem("from", "0.009,0.009,0.04");
  run.dem("to", "0.01,0.01,0.041")
      .dem("frozen", 1)
      .dem("radius", 1e-8)
      .dem("step", 1e-3)
      .dem("steps", 3000);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  const auto U = run.values("U");
  ASSERT_EQ(U.size(), 128u);
  const double factor = n / (n + 1) * std::pow(G / k, 1 / n),
               most = factor * std::pow(h, 1 + 1 / n);
  for (std::size_t row = 0; row < 32; ++row) {
    const double z = std::fabs((static_cast<double>(row) + 0.5) * 0.0025 - h);
    EXPECT_NEAR(U[4 * row][0] / most, 1 - std::pow(z / h, 1 + 1 / n), 0.01) << row;
  }
}

// At the terminal velocity drag carries the submerged weight (model B)
TEST(WriteFields, DragSumsUpToTheWeightItCarries) {
  for (int ranks : {1, 2}) {
    CoupledRun run("writeFields-" + std::to_string(ranks));
    run.ranks(1, ranks);
    run.box("x1 0.02; y1 0.02; z1 0.04; nx 2; ny 2; nz 4; nu 1e-3;");
    run.dem("hi", "0.02,0.02,0.04").dem("from", "0,0,0.02").dem("to", "0.02,0.02,0.04");
    run.dem("count", "4,4,4").dem("gravity", "0,0,-9.81").dem("density", 2600).dem("steps", 1000);
    run.dem("radius", 5e-4);
    run.properties("model B; writeFields (Us drag exchangeCoefficient);");
    ASSERT_EQ(run.meshAndRun(), 0) << run.log();
    if (ranks > 1) continue;
    const double cell = 1e-6, one = 1600 * 9.81 * pi / 6 * 1e-9;
    const auto drag = run.values("drag"), Us = run.values("Us"), U = run.values("U");
    const auto K = run.scalars("exchangeCoefficient");
    double sum = 0, byCells = 0;
    for (std::size_t i = 0; i < drag.size(); ++i) {
      sum += drag[i][2] * cell;
      byCells += K[i] * (U[i][2] - Us[i][2]) * cell;
    }
    EXPECT_NEAR(sum / (64 * one), 1, 5e-3);
    EXPECT_NEAR(byCells / sum, 1, 0.05);
  }
}

// The field's sum over the cells is what the DEM half makes of the last answers, whether drag was
// stiff or not; n at the spheres is that of their cells
TEST(WriteFields, DragSumsUpToWhatTheParticlesGet) {
  for (const double nu : {1e-6, 0.1}) {
    CoupledRun run(nu > 1e-3 ? "writeFields-stiff" : "writeFields-light");
    std::ostringstream entries;
    entries << "x1 0.02; y1 0.02; z1 0.04; nx 2; ny 2; nz 4; nu " << nu << ";";
    run.box(entries.str());
    run.dem("hi", "0.02,0.02,0.04").dem("from", "0,0,0.01").dem("to", "0.02,0.02,0.03");
    run.dem("count", "4,4,4").dem("gravity", "0,0,-9.81").dem("density", 2600).dem("steps", 200);
    run.dem("radius", 5e-4);
    run.properties("voidFractionModel centre; writeFields (drag);");
    run.mesh();
    ASSERT_EQ(run.run(), 0) << run.log();
    EXPECT_EQ(run.log().find("drag is stiff") != std::string::npos, nu > 1e-3);
    double sum = 0;
    for (const auto& drag : run.values("drag")) sum += drag[2] * 1e-6;
    const auto history = run.history();
    const auto& answered = history[history.size() - 1]["answered"];
    EXPECT_NEAR(sum / answered[2].get<double>(), 1, 1e-6)
        << history[history.size() - 2]["answered"];
    EXPECT_NEAR(answered[3], 1 - 8 * pi / 6 * 1e-9 / 1e-6, 1e-3);
  }
}

namespace {

/// Velocity of one sphere after a stream of 1 m/s that was at rest has started at once: drag is
/// nothing, so it has what the pressure gave, rhoF/rhoP of the fluid's velocity.
double impelled(const std::string& name, const std::string& control, int& steps) {
  CoupledRun run(name);
  run.box(
      "x1 0.01; y1 0.01; z1 0.04; nx 1; ny 1; nz 8; sideType patch; bottomType patch; topType "
      "patch;"
      "sideU slip; bottomU fixedValue; topU zeroGradient; topP fixedValue; nu 1e-9; U0 (0 0 1);");
  run.edit("0/U", "{ type $bottomU; }", "{ type $bottomU; value uniform $U0; }");
  run.edit("0/U", "internalField   uniform $U0", "internalField   uniform (0 0 0)");
  run.edit("system/controlDict", "adjustTimeStep  $adjust;", control);
  run.dem("hi", "0.01,0.01,0.04").dem("from", "0.004,0.004,0.02").dem("to", "0.006,0.006,0.022");
  run.dem("radius", 1e-4).dem("step", 1e-4).dem("interval", 10).dem("steps", 30);
  run.properties("dragModel Stokes; forceModels (pressureGradient);");
  EXPECT_EQ(run.meshAndRun(), 0) << run.log();
  steps = run.cfd()["cfd_steps"];
  return run.lastVelocity();
}

}  // namespace

// An impulse of the pressure reaches the particles whatever step of the interval it falls in
TEST(PressureGradient, IsTheMeanOverTheStepsOfAnInterval) {
  int steps = 0;
  EXPECT_NEAR(impelled("impelled", "adjustTimeStep no;", steps), rhoF / 2600, 2e-3);
  EXPECT_EQ(steps, 3);
  EXPECT_NEAR(impelled("impelled-in-steps", "deltaT 2e-4; adjustTimeStep no;", steps), rhoF / 2600,
              2e-3);
  EXPECT_EQ(steps, 15);
}

// A case that does not say whether steps adapt gets no longer ones than it asks for
TEST(TimeStep, IsNoLongerThanDeltaTWhereTheCaseDoesNotSayThatItAdapts) {
  int steps = 0;
  impelled("deltaT-alone", "deltaT 2.5e-4; maxCo 1e3;", steps);
  EXPECT_EQ(steps, 12);
  impelled("deltaT-adapts", "deltaT 2.5e-4; maxCo 1e3; adjustTimeStep yes;", steps);
  EXPECT_EQ(steps, 3);
}
