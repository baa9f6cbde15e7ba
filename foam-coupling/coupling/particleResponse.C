// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "particleResponse.H"

#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::particleResponse::stiffness
(
    const particle& q,
    const scalar T
)
{
    return q.K*T/(q.mass + q.added);
}


Foam::particleResponse::guess Foam::particleResponse::inMomentum()
{
    return {0.4, 0.7, 1};
}


Foam::particleResponse::guess
Foam::particleResponse::inContinuity(const scalar x)
{
    const scalar e = std::exp(-x);
    return {1 + 3*e, 1, 1 - 0.5*e};
}


Foam::particleResponse::answer Foam::particleResponse::foresee
(
    const particle& q,
    const scalar T,
    const scalar Tlast,
    const guess& of
)
{
    const scalar mass = q.mass + q.added;
    const scalar x = stiffness(q, T);

    // 1 - a and 1 - exp(-x), and both over K, all finite for K -> 0
    const scalar a =
        x > 1e-4 ? -std::expm1(-x)/x : 1 - 0.5*x*(1 - x/3);
    const scalar h = x > 1e-4 ? 1 - a : 0.5*x*(1 - x/3);
    const scalar hByK = T/mass*(x > 1e-4 ? h/x : 0.5*(1 - x/3));
    const scalar g = x*a;
    const scalar gByK = T/mass*a;

    if (!q.touched)
    {
        const vector force(q.other + q.load);
        return
        {
            a*q.velocity + hByK*force - h*q.own,
            h,
            hByK,
            gByK*force - g*(q.velocity + q.own),
            g,
            gByK
        };
    }

    // the fluid's pull in the interval before, less K vMean
    vector pull(Tlast > 0 ? q.impulse/Tlast : -q.other);
    pull += q.added/q.mass*(pull + q.other);

    const vector before(h*q.mean + hByK*pull);
    const scalar c = of.momentary/(1 + x);

    return
    {
        c*(a*q.velocity + before + hByK*q.other) + (1 - c)*of.kept*q.mean
      + of.part*(hByK*q.load - h*q.own - before),
        of.part*h,
        of.part*hByK,
        of.part*(gByK*(q.load - pull) - g*(q.own + q.mean)),
        of.part*g,
        of.part*gByK
    };
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::particleResponse::finish
(
    const smoothingModel& smoothing,
    GeometricField<Type, fvPatchField, volMesh>& sums
) const
{
    Field<Type>& cells = sums.primitiveFieldRef();
    cells /= mesh_.V();

    smoothing.smooth(cells);
    sums.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

namespace
{

template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh> cellSums
(
    const Foam::fvMesh& mesh,
    const Foam::word& name,
    const Foam::dimensionSet& dims
)
{
    return Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>
    (
        Foam::IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        Foam::dimensioned<Type>(dims, Foam::Zero),
        Foam::zeroGradientFvPatchField<Type>::typeName
    );
}

} // End anonymous namespace


Foam::particleResponse::particleResponse
(
    const fvMesh& mesh,
    const scalar rho
)
:
    mesh_(mesh),
    rho_(rho),
    active_(false),
    drag_(cellSums<scalar>(mesh, "responseDrag", dimDensity/dimTime)),
    source_(cellSums<vector>(mesh, "responseSource", dimForce/dimVolume)),
    pressure_(cellSums<scalar>(mesh, "responsePressure", dimless)),
    reaction_(cellSums<scalar>(mesh, "responseReaction", dimless)),
    share_(cellSums<scalar>(mesh, "responseShare", dimless)),
    mobility_(cellSums<scalar>(mesh, "responseMobility", dimTime)),
    flux_(cellSums<vector>(mesh, "responseFlux", dimVelocity)),
    pay_(mesh.nCells(), 1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleResponse::leave()
{
    active_ = false;
}


void Foam::particleResponse::foresee
(
    const dispersedParticles& p,
    const UList<particle>& particles,
    const scalar T,
    const scalar Tlast,
    const bool pressure,
    const couplingProperties::ddtType ddt,
    const smoothingModel& smoothing
)
{
    active_ = true;

    scalarField& drag = drag_.primitiveFieldRef();
    vectorField& source = source_.primitiveFieldRef();
    scalarField& off = pressure_.primitiveFieldRef();
    scalarField& reaction = reaction_.primitiveFieldRef();
    scalarField& share = share_.primitiveFieldRef();
    scalarField& mobility = mobility_.primitiveFieldRef();
    vectorField& flux = flux_.primitiveFieldRef();
    drag = Zero;
    source = Zero;
    off = Zero;
    reaction = Zero;
    share = Zero;
    mobility = Zero;
    flux = Zero;
    scalarField touched(drag.size(), Zero), all(drag.size(), Zero);

    const bool particleFlux = ddt == couplingProperties::ddtType::particleFlux;
    const bool displaced = ddt != couplingProperties::ddtType::none;

    forAll(particles, i)
    {
        const particle& q = particles[i];
        const answer m = foresee(q, T, Tlast, inMomentum());
        const answer c =
            foresee(q, T, Tlast, inContinuity(stiffness(q, T)));
        const scalar V = p.volume[i];

        const scalar inertia = q.added/T;
        const scalar Ki = q.K*(1 - m.s) - inertia*m.g;
        const vector Fi(q.K*(m.b + q.own) + inertia*m.c);
        // the solids' flux that the equation of continuity has already
        const vector& had = particleFlux ? q.velocity : q.mean;
        const vector Qi(V*(c.b + c.s*q.fluid + c.sByK*q.push - had));
        for (label e = p.offset[i]; e < p.offset[i + 1]; ++e)
        {
            const label celli = p.cellIndex[e];
            const scalar w = p.weight[e];
            drag[celli] += w*Ki;
            source[celli] += w*Fi;
            if (displaced)
            {
                share[celli] += w*V*c.s;
                flux[celli] += w*Qi;
            }
            if (pressure)
            {
                off[celli] += w*V*(w - m.s - inertia*m.gByK);
                reaction[celli] += w*w*V;
            }
            if (displaced && pressure)
            {
                mobility[celli] += w*V*V*rho_*c.sByK;
            }
            all[celli] += w*q.K;
            if (q.touched)
            {
                touched[celli] += w*q.K;
            }
        }
    }

    finish(smoothing, drag_);
    finish(smoothing, source_);
    finish(smoothing, pressure_);
    finish(smoothing, reaction_);
    finish(smoothing, share_);
    finish(smoothing, mobility_);
    finish(smoothing, flux_);

    forAll(pay_, celli)
    {
        pay_[celli] =
            all[celli] > VSMALL
          ? 1 - (1 - paid)*touched[celli]/all[celli]
          : 1;
    }
}
