// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

// What the two halves tell each other before the first state.

#include "particleCoupling.H"

#include "OStringStream.H"
#include "meshPeriod.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static clay::Box box(const boundBox& bounds)
{
    clay::Box b;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        b.lo[d] = bounds.min()[d];
        b.hi[d] = bounds.max()[d];
    }
    return b;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

clay::RankBoxes Foam::particleCoupling::boxes() const
{
    const boundBox mine(mesh_.points(), false);
    clay::RankBoxes all{box(mine)};

    // a single rank gets all particles, and finds their images itself
    if (Pstream::parRun() && mesh_.nCells())
    {
        for (const vector& way : mapping_->images())
        {
            all.push_back(box(boundBox(mine.min() - way, mine.max() - way)));
        }
    }
    return all;
}


clay::CfdTerms Foam::particleCoupling::terms() const
{
    using clay::Field;

    const Time& runTime = mesh_.time();
    clay::CfdTerms t;

    t.program = "clayFoam on OpenFOAM v" + std::to_string(OPENFOAM);
    t.startTime = runTime.value() - properties_.timeOffset();

    if
    (
        runTime.controlDict().found("endTime")
     && runTime.controlDict().lookupOrDefault<word>("stopAt", "endTime")
     == "endTime"
    )
    {
        t.endTime =
            runTime.controlDict().get<scalar>("endTime")
          - properties_.timeOffset();
    }
    if (properties_.interval() > 0)
    {
        t.couplingInterval = properties_.interval();
    }

    IOobject gHeader
    (
        "g",
        runTime.constant(),
        runTime,
        IOobject::READ_IF_PRESENT,
        IOobject::NO_WRITE,
        false
    );
    if (gHeader.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        const uniformDimensionedVectorField g(gHeader);
        t.gravity = {{g.value().x(), g.value().y(), g.value().z()}};
    }

    t.pair = startPair_;
    t.fluidDensity = rho_;
    t.fluidViscosity = rho_*nu_;
    t.box = box(boundBox(mesh_.points(), true));
    t.overlap = properties_.overlap();
    t.needs =
    {
        Field::position, Field::radius, Field::volume, Field::velocity,
        Field::tag, Field::impulse, Field::mass, Field::meanVelocity,
        Field::otherForce, Field::touched
    };
    t.buoyancy = properties_.has("buoyancy");
    t.period = meshPeriod(mesh_);
    t.open = openSides(mesh_);
    t.accepts = {Field::dragDiameter, Field::dragFactor, Field::gravity};
    t.offers =
    {
        Field::dragCoefficient, Field::fluidVelocity, Field::force,
        Field::voidFraction
    };
    if (forces_.needsSpin())
    {
        t.needs.add(Field::spin);
    }
    if (forces_.addedDensity() > 0)
    {
        t.offers.add(Field::addedMass);
    }
    if (forces_.turns())
    {
        t.offers.add(Field::turnCoefficient);
        t.offers.add(Field::fluidSpin);
    }
    return t;
}


void Foam::particleCoupling::checkBuoyancy()
{
    const auto& g = session_->remoteTerms().gravity;
    gravity_ = vector(g[0], g[1], g[2]);

    const bool any =
        mag(gravity_) > 0 || session_->receives().has(clay::Field::gravity);
    if (any && !properties_.has("buoyancy"))
    {
        OStringStream os;
        os  << "forceModels " << listed(properties_.forces()).c_str()
            << " lacks buoyancy, but the DEM half has gravity " << gravity_
            << " m/s2";
        if (!properties_.allowNoBuoyancy())
        {
            FatalIOErrorInFunction(properties_)
                << os.str().c_str() << "; list it, or set allowNoBuoyancy yes"
                << exit(FatalIOError);
        }
        stats_.warn(os.str());
    }
    if (properties_.modelA() && !properties_.has("pressureGradient"))
    {
        stats_.warn
        (
            "forceModels lacks pressureGradient, which belongs to model A"
        );
    }
}
