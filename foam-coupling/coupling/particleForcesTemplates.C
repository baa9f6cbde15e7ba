// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#ifndef particleForcesTemplates_C
#define particleForcesTemplates_C

#include "particleForces.H"

#include "interpolation.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::particleForces::mean
(
    const Field<Type>& cells,
    const dispersedParticles& p
) const
{
    auto tvalues = tmp<Field<Type>>::New(p.size(), Zero);
    Field<Type>& values = tvalues.ref();
    forAll(values, i)
    {
        for (label e = p.offset[i]; e < p.offset[i + 1]; ++e)
        {
            values[i] += p.weight[e]*cells[p.cellIndex[e]];
        }
    }
    // all ranks alike: there is one or there are several
    if (sumShared_)
    {
        const int width = pTraits<Type>::nComponents;
        std::vector<double> parts(width*values.size());
        forAll(values, i)
        {
            for (int d = 0; d < width; ++d)
            {
                parts[width*i + d] = component(values[i], d);
            }
        }
        sumShared_(parts, width);
        forAll(values, i)
        {
            for (int d = 0; d < width; ++d)
            {
                setComponent(values[i], d) = parts[width*i + d];
            }
        }
    }
    return tvalues;
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::particleForces::sample
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const dispersedParticles& p
) const
{
    // all ranks alike: a setting
    if (properties_.interpolation() == "mapped")
    {
        // all ranks alike: settings
        if (!bothWays())
        {
            return mean(field.primitiveField(), p);
        }
        // as the particles' own forces go to the cells
        Field<Type> cells(field.primitiveField());
        smoothing_.smooth(cells);
        return mean(cells, p);
    }

    auto tvalues = tmp<Field<Type>>::New(p.size(), Zero);
    Field<Type>& values = tvalues.ref();

    autoPtr<interpolation<Type>> scheme;
    if (properties_.interpolation() != "cell")
    {
        scheme = interpolation<Type>::New(properties_.interpolation(), field);
    }

    forAll(values, i)
    {
        if (p.owned[i])
        {
            // a centre outside of the mesh takes the value of its cell
            values[i] =
                scheme.valid() && !(p.outside[i] > 0)
              ? scheme->interpolate(p.position[i], p.cell[i])
              : field[p.cell[i]];
        }
    }

    return tvalues;
}


// ************************************************************************* //

#endif
