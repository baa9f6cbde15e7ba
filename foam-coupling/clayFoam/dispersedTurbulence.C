// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "dispersedTurbulence.H"

#include "LESModel.H"
#include "RASModel.H"
#include "addToRunTimeSelectionTable.H"
#include "laminarModel.H"
#include "makeTurbulenceModel.H"

// * * * * * * * * * * * * * * * * * Selection * * * * * * * * * * * * * * * //

makeTurbulenceModelTypes
(
    volScalarField,
    geometricOneField,
    incompressibleTurbulenceModel,
    dispersedTurbulence,
    transportModel
);

makeBaseTurbulenceModel
(
    volScalarField,
    geometricOneField,
    incompressibleTurbulenceModel,
    dispersedTurbulence,
    transportModel
);

#define offerModel(Kind, Type)                                                 \
    makeTemplatedTurbulenceModel                                               \
    (transportModeldispersedTurbulence, Kind, Type)

// declared by laminarModel.H; "Stokes.H" would be that of the drag models
offerModel(laminar, Stokes);

#include "SpalartAllmaras.H"
offerModel(RAS, SpalartAllmaras);
#include "kEpsilon.H"
offerModel(RAS, kEpsilon);
#include "RNGkEpsilon.H"
offerModel(RAS, RNGkEpsilon);
#include "realizableKE.H"
offerModel(RAS, realizableKE);
#include "LaunderSharmaKE.H"
offerModel(RAS, LaunderSharmaKE);
#include "kOmega.H"
offerModel(RAS, kOmega);
#include "kOmegaSST.H"
offerModel(RAS, kOmegaSST);

#include "Smagorinsky.H"
offerModel(LES, Smagorinsky);
#include "WALE.H"
offerModel(LES, WALE);
#include "kEqn.H"
offerModel(LES, kEqn);
#include "dynamicKEqn.H"
offerModel(LES, dynamicKEqn);


// ************************************************************************* //
