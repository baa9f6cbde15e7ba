// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "savedPart.H"

#include "IOdictionary.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"
#include "calculatedFvPatchFields.H"

#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const word pairName("couplingPair");

static std::vector<savedPart*>& parts()
{
    static std::vector<savedPart*> all;
    return all;
}

static IOobject io
(
    const fvMesh& mesh,
    const word& name,
    const IOobject::readOption read
)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        read,
        IOobject::NO_WRITE,
        false
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::stateWriter::write(const regIOobject& object) const
{
    const fileName path(folder_/object.local()/object.name());
    mkDir(path.path());

    OFstream os(path, IOstream::BINARY);
    os.precision(17);
    if (os.good() && object.writeHeader(os) && object.writeData(os))
    {
        os.flush();
    }
    if (!os.good())
    {
        FatalErrorInFunction
            << "cannot write " << path << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stateWriter::stateWriter(const fvMesh& mesh, const fileName& folder)
:
    mesh_(mesh),
    folder_(folder),
    precision_(IOstream::defaultPrecision(17))
{
    mkDir(folder_);
}


Foam::stateWriter::~stateWriter()
{
    IOstream::defaultPrecision(precision_);
}


Foam::savedPart::savedPart()
{
    parts().push_back(this);
}


Foam::savedPart::~savedPart()
{
    auto& all = parts();
    all.erase(std::find(all.begin(), all.end(), this));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::stateWriter::cells
(
    const word& name,
    const Field<Type>& values
) const
{
    GeometricField<Type, fvPatchField, volMesh> field
    (
        io(mesh_, name, IOobject::NO_READ),
        mesh_,
        dimensioned<Type>(dimless, Zero),
        calculatedFvPatchField<Type>::typeName
    );
    field.primitiveFieldRef() = values;
    write(field);
}


void Foam::stateWriter::faces
(
    const word& name,
    const surfaceScalarField& values
) const
{
    surfaceScalarField field(io(mesh_, name, IOobject::NO_READ), values);
    field.setOriented();
    write(field);
}


void Foam::stateWriter::finish() const
{
    const Time& time = mesh_.time();
    const auto output = [&](const objectRegistry& registry)
    {
        forAllConstIters(registry, iter)
        {
            const regIOobject& object = *iter.val();
            if
            (
                object.writeOpt() == IOobject::AUTO_WRITE
             && object.instance() != time.constant()
             && object.instance() != time.system()
             && !isA<objectRegistry>(object)
            )
            {
                write(object);
            }
        }
    };
    output(mesh_.thisDb());
    output(time);

    IOdictionary numbers
    (
        IOobject
        (
            pairName,
            time.timeName(),
            "uniform",
            time,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        numbers_
    );
    write(numbers);
}


void Foam::savedPart::saveAll(stateWriter& to)
{
    for (savedPart* part : parts())
    {
        part->save(to);
    }
}


// * * * * * * * * * * * * * * * Other Functions * * * * * * * * * * * * * * //

bool Foam::hasSavedNumbers(const fvMesh& mesh)
{
    const bool here = isFile(mesh.time().timePath()/"uniform"/pairName);
    const bool all = returnReduce(here, andOp<bool>());
    if (all != returnReduce(here, orOp<bool>()))
    {
        FatalErrorInFunction
            << "uniform/" << pairName << " of time " << mesh.time().timeName()
            << " is there in some processor folders only: the saved state is"
            << " not whole" << exit(FatalError);
    }
    return all;
}


Foam::dictionary Foam::savedNumbers(const fvMesh& mesh)
{
    // all ranks alike: it is collective itself
    if (!hasSavedNumbers(mesh))
    {
        return dictionary();
    }
    IFstream is(mesh.time().timePath()/"uniform"/pairName);
    dictionary numbers(is);
    numbers.remove("FoamFile");
    return numbers;
}


template<class Type>
void Foam::readCells(const fvMesh& mesh, const word& name, Field<Type>& to)
{
    const GeometricField<Type, fvPatchField, volMesh> field
    (
        io(mesh, name, IOobject::MUST_READ),
        mesh
    );
    to = field.primitiveField();
}


Foam::tmp<Foam::surfaceScalarField> Foam::readFaces
(
    const fvMesh& mesh,
    const word& name
)
{
    return tmp<surfaceScalarField>::New
    (
        io(mesh, name, IOobject::MUST_READ),
        mesh
    );
}


namespace Foam
{
template void stateWriter::cells(const word&, const Field<scalar>&) const;
template void stateWriter::cells(const word&, const Field<vector>&) const;
template void readCells(const fvMesh&, const word&, Field<scalar>&);
template void readCells(const fvMesh&, const word&, Field<vector>&);
}


// ************************************************************************* //
