// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_runs.cpp
/// Two programs in one mpirun: what they exchange, and how they end.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "exchange/test_shell.h"

namespace {

void expectDone(const Outcome& o, int dem, int cfd) {
  EXPECT_EQ(o.code, 0) << o.text;
  int demDone = 0, cfdDone = 0;
  for (std::size_t at = 0; (at = o.text.find("half done after", at)) != std::string::npos; ++at)
    (o.text.compare(at - 4, 3, "DEM") == 0 ? demDone : cfdDone)++;
  EXPECT_EQ(demDone, dem) << o.text;
  EXPECT_EQ(cfdDone, cfd) << o.text;
}

// The run has ended in time, with a failure, and says why
void expectEnd(const Outcome& o, const std::string& reason) {
  EXPECT_NE(o.code, 0) << o.text;
  EXPECT_NE(o.code, 124) << "it hung: " << o.text;
  EXPECT_LT(o.seconds, 10) << o.text;
  EXPECT_TRUE(o.says(reason)) << "no '" << reason << "' in: " << o.text;
  EXPECT_FALSE(o.says("NOT TRUE")) << o.text;
  EXPECT_FALSE(o.says("half done after")) << o.text;
}

const std::string demStops = "test_dem_half: stopped: the CFD half ended: ";
const std::string cfdStops = "test_cfd_half: stopped: the DEM half ended: ";

TEST(Echo, OneAndOne) { expectDone(run("echo", 1, 1), 1, 1); }
TEST(Echo, TwoAndThree) { expectDone(run("echo", 2, 3), 2, 3); }
TEST(Echo, ThreeAndOne) { expectDone(run("echo", 3, 1), 3, 1); }

TEST(Echo, TheCfdHalfMayHoldTheLowRanks) {
  expectDone(shell(std::string(MPIRUN) + " " + part(CFD_HALF, "echo", 2) + " : " +
                   part(DEM_HALF, "echo", 2)),
             2, 2);
}

TEST(Echo, AHalfMayBeStartedInParts) {
  expectDone(shell(std::string(MPIRUN) + " " + part(DEM_HALF, 1, "echo 2") + " : " +
                   part(CFD_HALF, 2, "echo 2") + " : " + part(DEM_HALF, 1, "echo 2")),
             2, 2);
}

// as with srun --multi-prog: the launcher knows of one program
TEST(Echo, RanksMayChooseTheirProgram) {
  const std::string choose = std::string("case $OMPI_COMM_WORLD_RANK in 1|3) exec ") + DEM_HALF +
                             " echo 2;; *) exec " + CFD_HALF + " echo 3;; esac";
  expectDone(shell(std::string(MPIRUN) + " -np 5 sh -c '" + choose + "'"), 2, 3);
}

TEST(Echo, AFurtherRunGoesOn) {
  const Outcome o = run("resume", 2, 2);
  expectDone(o, 2, 2);
  EXPECT_TRUE(o.says("after 12 exchanges")) << o.text;
}

TEST(Echo, OfHostsThatSplitTheWorldThemselves) {
  const Outcome o = shell(std::string(MPIRUN) + " -np 2 " + ADOPT_HALF + " dem 0 : -np 3 " +
                          ADOPT_HALF + " cfd 1");
  EXPECT_EQ(o.code, 0) << o.text;
  EXPECT_TRUE(o.says("5 ranks are done")) << o.text;
}

TEST(Echo, MpiIsEndedForAHostThatDoesNot) { expectDone(run("noFinalize", 1, 2), 1, 2); }

TEST(Refused, OnEveryRankOfBothHalves) {
  const Outcome o = run("refused", 2, 2);
  expectEnd(o, "DEM half: the end times differ: 1.001 s in the DEM half, 0.001 s in the CFD half");
  EXPECT_TRUE(o.says("CFD half: the end times differ: 1.001 s in the DEM half")) << o.text;
}

TEST(Refused, AFurtherRunAsWell) {
  const Outcome o = run("resumeRefused", 1, 2);
  expectEnd(o, "DEM half: the gravities differ: (0 0 -1) m/s2 in the DEM half");
  EXPECT_TRUE(o.says("CFD half: the gravities differ")) << o.text;
}

TEST(Refused, AHalfStartedAlone) {
  expectEnd(shell(std::string(MPIRUN) + " " + part(DEM_HALF, "echo", 2)),
            "DEM half: started alone, no CFD half is in this mpirun");
  expectEnd(shell(std::string(MPIRUN) + " " + part(CFD_HALF, "echo", 2)),
            "CFD half: started alone, no DEM half is in this mpirun");
}

TEST(Refused, AHalfStartedWithoutMpirun) {
  expectEnd(shell(std::string(CFD_HALF) + " echo 1"), "CFD half: started alone");
}

TEST(Refused, OneHalfInTwoParts) {
  expectEnd(shell(std::string(MPIRUN) + " " + part(DEM_HALF, 1, "echo 2") + " : " +
                  part(DEM_HALF, 1, "echo 2")),
            "DEM half: started alone, no CFD half is in this mpirun");
}

TEST(Refused, TwoHalvesOfOneKind) {
  // hosts that split the world themselves: the wrappers would make one half of them
  expectEnd(shell(std::string(MPIRUN) + " " + part(ADOPT_HALF, 1, "dem 0") + " : " +
                  part(ADOPT_HALF, 1, "dem 1")),
            "both programs of this mpirun are DEM halves");
}

TEST(Refused, ASessionOfTheOtherHalf) {
  expectEnd(shell(std::string(MPIRUN) + " " + part(ADOPT_HALF, 1, "dem 0 cfd") + " : " +
                  part(ADOPT_HALF, 1, "cfd 1")),
            "a session of the DEM half in a program of the CFD half");
}

// the first word counts, and comes to the first rank
TEST(Ends, WhenTheCfdHalfAsksForIt) {
  const Outcome o = run("asked", 2, 2);
  expectEnd(o, cfdStops + "asked to end by signal 15 on rank 0");
  EXPECT_FALSE(o.says("on rank 1")) << o.text;
}

TEST(Ends, WhenTheDemHalfExitsWithoutAnError) {
  expectEnd(run("dem:exit0", 1, 2), cfdStops + "test_dem_half ended before the coupled run did");
}
TEST(Ends, WhenTheDemHalfExitsWithAnError) {
  expectEnd(run("dem:exit3", 2, 1), cfdStops + "test_dem_half ended before the coupled run did");
}
TEST(Ends, WhenOneDemRankExits) {
  expectEnd(run("dem0:exit3", 2, 2), cfdStops + "test_dem_half ended before the coupled run did");
}
TEST(Ends, WhenTheCfdHalfExitsWithoutAnError) {
  expectEnd(run("cfd:exit0", 2, 1), demStops + "test_cfd_half ended before the coupled run did");
}
TEST(Ends, WhenTheCfdHalfExitsWithAnError) {
  expectEnd(run("cfd:exit3", 1, 2), demStops + "test_cfd_half ended before the coupled run did");
}
TEST(Ends, WhenTheDemHalfEndsAsLiggghtsDoesOnErrors) {
  expectEnd(run("dem:error", 2, 2), cfdStops + "test_dem_half ended before the coupled run did");
}
TEST(Ends, WhenTheDemHalfFinalizesEarly) {
  expectEnd(run("dem:finalize", 1, 1), cfdStops + "test_dem_half ended before the coupled run did");
}
TEST(Ends, WhenTheDemHalfDoesNotClose) {
  const Outcome o = run("noClose", 1, 1);
  EXPECT_NE(o.code, 0) << o.text;
  EXPECT_LT(o.seconds, 10);
  EXPECT_TRUE(o.says(cfdStops + "test_dem_half ended before the coupled run did")) << o.text;
}
TEST(Ends, WhenTheDemHalfNeverCouples) {
  for (const char* way : {"before:dem:finalize", "before:dem:error", "before:dem:exit0"})
    expectEnd(run(way, 1, 2), cfdStops + "test_dem_half ended without ever coupling");
}
TEST(Ends, WhenTheCfdHalfNeverCouples) {
  expectEnd(run("before:cfd:exit0", 2, 1), demStops + "test_cfd_half ended without ever coupling");
}
TEST(Ends, WhenAHalfAborts) {
  expectEnd(run("cfd:abort", 1, 2), demStops + "test_cfd_half called MPI_Abort with code 7");
  expectEnd(run("dem0:abort", 2, 1), cfdStops + "test_dem_half called MPI_Abort with code 7");
}
TEST(Ends, WhenAHalfThrows) {
  expectEnd(run("dem:throw", 1, 1), cfdStops + "ended by an uncaught exception: no more cheese");
  expectEnd(run("cfd0:throw", 1, 2), demStops + "ended by an uncaught exception: no more cheese");
}
TEST(Ends, WhenAHalfAbandonsTheRun) {
  const Outcome o = run("cfd0:abandon", 2, 2);
  expectEnd(o, demStops + "no more cheese");
  EXPECT_TRUE(o.says("test_cfd_half: no more cheese")) << o.text;
}
TEST(Ends, WithOneLineWhenAllRanksAbandonTheRun) {
  const Outcome o = run("dem:abandon", 3, 1, "TEST_SAVE_SECONDS=1");
  expectEnd(o, cfdStops + "no more cheese");
  const std::string line = "test_dem_half: no more cheese";
  EXPECT_EQ(o.text.find(line), o.text.rfind(line)) << o.text;
}
TEST(Ends, WhenAHalfIsKilled) {
  expectEnd(run("dem0:kill", 2, 2), "signal 9");
  expectEnd(run("cfd:kill", 1, 1), "signal 9");
}
TEST(Ends, WhenAHalfLeavesWithoutAWord) {
  expectEnd(run("dem:_exit0", 1, 1), "exiting improperly");
}

TEST(Ends, WhenAParticleLeavesTheMesh) {
  const Outcome o = run("lost", 2, 3);
  expectEnd(o, "test_dem_half: particle 18 at (1.5 ");
  EXPECT_TRUE(o.says("lies outside the mesh, (0 0 0) to (1 0.5 0.5) m")) << o.text;
  EXPECT_TRUE(o.says(cfdStops + "particle 18 at")) << o.text;
}

TEST(Runs, WithAParticleBeyondAnOpenSide) {
  const Outcome o = run("leaves", 2, 3);
  EXPECT_EQ(o.code, 0) << o.text;
  EXPECT_TRUE(o.says("DEM half done after")) << o.text;
}

TEST(Ends, AfterTheOtherHalfHasSavedItsState) {
  const Outcome o = run("dem:error", 1, 3, "TEST_SAVE_SECONDS=3");
  expectEnd(o, "CFD rank 0 saved its state: test_dem_half ended");
  EXPECT_TRUE(o.says("CFD rank 1 saved its state")) << o.text;
  EXPECT_TRUE(o.says("CFD rank 2 saved its state")) << o.text;
}

TEST(Ends, WhenAHalfIsSilentTooLong) {
  const std::string limit = "CLAYFOAM_TIMEOUT=1.5";
  expectEnd(run("dem:sleep", 1, 2, limit), "for the DEM half's next state; CLAYFOAM_TIMEOUT");
  expectEnd(run("cfd:sleep", 2, 1, limit), "for the CFD half's answer; CLAYFOAM_TIMEOUT");
  expectEnd(run("before:dem:sleep", 1, 1, limit), "for the other half's terms; CLAYFOAM_TIMEOUT");
}

// One that is stopped before MPI_Init, never calls it, or has gone: MPI itself would wait for ever
TEST(Ends, WhenAProgramDoesNotStartMpi) {
  for (const char* other : {"kill -STOP $$", "sleep 40", "true"}) {
    const Outcome o = shell(std::string("env CLAYFOAM_TIMEOUT=2 ") + MPIRUN + " -np 1 sh -c '" +
                            other + "' : " + part(CFD_HALF, "echo", 1));
    EXPECT_NE(o.code, 0) << other << o.text;
    EXPECT_LT(o.seconds, 20) << other << o.text;
    EXPECT_TRUE(o.says("test_cfd_half: waited 2 s for all programs of this mpirun to start MPI"))
        << other << o.text;
  }
}

// Open MPI 5 names itself to the programs by another variable than 4, and ends them alike
TEST(Ends, ByTheExitCodeAloneWhereMpirunSeesIt) {
  const std::string as4 = "env -u PRTE_LAUNCHED ",
                    as5 = "env -u OMPI_MCA_orte_launch PRTE_LAUNCHED=1 ",
                    none = "env -u OMPI_MCA_orte_launch -u PRTE_LAUNCHED ";
  for (const auto& launcher : {as4, as5, none}) {
    std::string line = std::string(MPIRUN) + " -np 1 ";
    line.append(launcher).append(DEM_HALF " cfd:explained 1 : -np 1 ");
    line.append(launcher).append(CFD_HALF " cfd:explained 1");
    const Outcome o = shell(line);
    expectEnd(o, "no cheese at all");
    // mpirun's text, which it loses on its way now and then, and says so
    const bool shown = o.says("MPI_ABORT was invoked") || o.says("show_help.c");
    EXPECT_EQ(shown, launcher == none) << launcher << o.text;
  }
}

// The reason that a program gives goes along
TEST(Ends, WithTheLastWords) {
  expectEnd(run("cfd:words", 1, 2),
            demStops + "test_cfd_half called MPI_Abort with code 7; state 7 is left");
  const Outcome o = run("dem:ownWords", 1, 1);
  expectEnd(o, cfdStops + "no more cheese; state 7 is left");
  EXPECT_FALSE(o.says("is left; state")) << "said once: " << o.text;
}
TEST(Ends, WithTheReasonThatWasExplained) {
  expectEnd(run("before:dem:explained", 1, 2),
            cfdStops + "test_dem_half ended without ever coupling: no cheese at all");
  expectEnd(run("cfd:explained", 1, 1),
            demStops + "test_cfd_half ended before the coupled run did: no cheese at all");
}

TEST(Ends, WhenTheTimeLimitIsNoNumber) {
  expectEnd(run("echo", 1, 1, "CLAYFOAM_TIMEOUT=soon"),
            "CLAYFOAM_TIMEOUT is 'soon'; it must be a number of seconds above 0");
}

}  // namespace
