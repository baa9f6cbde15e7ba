// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "testMesh.H"
#include "IStringStream.H"
#include "OSspecific.H"
#include "calculatedFvPatchFields.H"
#include "processorPolyPatch.H"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <tuple>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
using namespace Foam;

struct sides
{
    face shape;             // out of its first cell
    label first, second;    // global cells, second -1 at the boundary
};

std::vector<sides> allSides(const test::polyhedra& all)
{
    std::map<std::vector<label>, size_t> known;
    std::vector<sides> faces;

    for (label c = 0; c < label(all.cells.size()); ++c)
    {
        for (const face& f : all.cells[c])
        {
            std::vector<label> key(f.begin(), f.end());
            std::sort(key.begin(), key.end());
            const auto at = known.find(key);
            if (at == known.end())
            {
                known[key] = faces.size();
                faces.push_back({f, c, -1});
            }
            else
            {
                faces[at->second].second = c;
            }
        }
    }
    return faces;
}

void write(const fileName& path, const std::string& object, const char* text)
{
    std::ofstream(path.c_str())
        << "FoamFile { version 2.0; format ascii; class dictionary; object "
        << object << "; }\n" << text;
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::test::meshCase::meshCase
(
    const polyhedra& all,
    const std::vector<std::string>& kinds
)
{
    std::string name
    (
        std::filesystem::temp_directory_path()/"clayFoamTest.XXXXXX"
    );
    if (!mkdtemp(&name[0]))
    {
        throw std::runtime_error("no folder for the test case");
    }
    folder_ = name;
    mkDir(folder_/"system");
    write
    (
        folder_/"system/fvSchemes", "fvSchemes",
        "ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }\n"
        "divSchemes { default none; }\n"
        "laplacianSchemes { default Gauss linear corrected; }\n"
        "interpolationSchemes { default linear; }\n"
        "snGradSchemes { default corrected; }\n"
    );
    write(folder_/"system/fvSolution", "fvSolution", "solvers {}\n");

    time_.reset
    (
        new Time
        (
            settings
            (
                "deltaT 1; endTime 1; writeControl timeStep; writeInterval 1;"
            ),
            folder_.path(), folder_.name(), "system", "constant", false, false
        )
    );

    const auto rankOf = [&](const label c)
    {
        return all.ranks.empty() ? 0 : all.ranks[c];
    };
    const label me = Pstream::parRun() ? Pstream::myProcNo() : 0;
    labelList local(all.cells.size(), -1);
    label nCells = 0;
    forAll(local, c)
    {
        if (rankOf(c) == me)
        {
            local[c] = nCells++;
        }
    }

    struct row
    {
        label own, nei;
        face shape;
    };
    std::vector<row> inner;
    std::vector<std::vector<row>> outer(kinds.empty() ? 1 : kinds.size());
    const boundBox bounds(all.points, false);
    const auto sideOf = [&](const face& f)
    {
        const point x(f.centre(all.points));
        label side = 0;
        for (label k = 0; k < label(kinds.size()); ++k)
        {
            const scalar end =
                k % 2 ? bounds.max()[k/2] : bounds.min()[k/2];
            if (mag(x[k/2] - end) < 1e-9*bounds.mag())
            {
                side = k;
            }
        }
        return side;
    };
    std::map<label, std::vector<row>> toRank;

    for (const sides& s : allSides(all))
    {
        const label a = local[s.first];
        const label b = s.second < 0 ? -1 : local[s.second];
        if (a >= 0 && b >= 0)
        {
            const bool up = a < b;
            inner.push_back
            (
                {min(a, b), max(a, b), up ? s.shape : s.shape.reverseFace()}
            );
        }
        else if (a >= 0 && s.second < 0)
        {
            outer[sideOf(s.shape)].push_back({a, -1, s.shape});
        }
        else if (a >= 0)
        {
            toRank[rankOf(s.second)].push_back({a, -1, s.shape});
        }
        else if (b >= 0)
        {
            toRank[rankOf(s.first)].push_back({b, -1, s.shape.reverseFace()});
        }
    }
    std::sort
    (
        inner.begin(), inner.end(),
        [](const row& x, const row& y)
        {
            return std::tie(x.own, x.nei) < std::tie(y.own, y.nei);
        }
    );

    // the points in use, in their order
    labelList pointMap(all.points.size(), -1);
    const auto use = [&](const std::vector<row>& rows)
    {
        for (const row& r : rows)
        {
            for (const label p : r.shape)
            {
                pointMap[p] = 0;
            }
        }
    };
    use(inner);
    for (const auto& rows : outer)
    {
        use(rows);
    }
    for (const auto& entry : toRank)
    {
        use(entry.second);
    }
    pointField points(all.points.size());
    label nPoints = 0;
    forAll(pointMap, p)
    {
        if (pointMap[p] == 0)
        {
            points[nPoints] = all.points[p];
            pointMap[p] = nPoints++;
        }
    }
    points.setSize(nPoints);

    DynamicList<face> faces;
    DynamicList<label> owner, neighbour;
    const auto put = [&](const std::vector<row>& rows)
    {
        for (const row& r : rows)
        {
            face f(r.shape);
            inplaceRenumber(pointMap, f);
            faces.append(f);
            owner.append(r.own);
            if (r.nei >= 0)
            {
                neighbour.append(r.nei);
            }
        }
    };
    put(inner);
    for (const auto& rows : outer)
    {
        put(rows);
    }
    for (const auto& entry : toRank)
    {
        put(entry.second);
    }

    mesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                polyMesh::defaultRegion, time_->constant(), *time_,
                IOobject::NO_READ, IOobject::NO_WRITE
            ),
            std::move(points),
            faceList(std::move(faces)),
            labelList(std::move(owner)),
            labelList(std::move(neighbour)),
            false
        )
    );

    List<polyPatch*> patches(outer.size() + toRank.size());
    label start = inner.size();
    label index = 0;
    for (const auto& rows : outer)
    {
        dictionary patch;
        patch.add("type", word(kinds.empty() ? "wall" : kinds[index]));
        patch.add("nFaces", label(rows.size()));
        patch.add("startFace", start);
        // the side across
        patch.add("neighbourPatch", word("side" + std::to_string(index ^ 1)));
        patches[index] = polyPatch::New
        (
            kinds.empty() ? "walls" : "side" + std::to_string(index),
            patch,
            index,
            mesh_->boundaryMesh()
        ).ptr();
        start += rows.size();
        ++index;
    }
    for (const auto& entry : toRank)
    {
        patches[index] = new processorPolyPatch
        (
            entry.second.size(), start, index, mesh_->boundaryMesh(),
            me, entry.first
        );
        start += entry.second.size();
        ++index;
    }
    mesh_->addFvPatches(patches);
}


Foam::test::meshCase::~meshCase()
{
    mesh_.reset();
    time_.reset();
    rmDir(folder_, true);
}


Foam::volScalarField Foam::test::meshCase::field(const word& name) const
{
    return volScalarField
    (
        IOobject(name, time_->timeName(), *mesh_),
        *mesh_,
        dimensionedScalar("n", dimless, 1),
        calculatedFvPatchScalarField::typeName
    );
}


// * * * * * * * * * * * * * * * Other Functions * * * * * * * * * * * * * * //

Foam::dictionary Foam::test::settings(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


std::vector<std::vector<std::string>> Foam::test::table
(
    const std::string& name
)
{
    std::ifstream in(std::string(CLAYFOAM_TEST_DATA) + "/" + name);
    if (!in)
    {
        throw std::runtime_error("no table " + name);
    }

    std::vector<std::vector<std::string>> rows;
    std::string line;
    bool names = false;
    while (std::getline(in, line))
    {
        if (line.empty() || line[0] == '#')
        {
            continue;
        }
        if (!names)
        {
            names = true;
            continue;
        }
        std::vector<std::string> row;
        std::stringstream cells(line);
        std::string cell;
        while (std::getline(cells, cell, ','))
        {
            row.push_back(cell);
        }
        rows.push_back(row);
    }
    return rows;
}
