// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "couplingProperties.H"
#include "checkedNumber.H"

#include "OStringStream.H"
#include "dragModel.H"
#include "forceModel.H"
#include "polyMesh.H"
#include "processorCyclicPolyPatch.H"
#include "selfDisturbanceModel.H"
#include "smoothingModel.H"
#include "solidFields.H"
#include "voidFractionModel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static std::string text(const Switch& value)
{
    return value ? "yes" : "no";
}

static std::string text(const word& value)
{
    return value;
}

static std::string text(const wordList& value)
{
    return listed(value);
}

static std::string text(const scalar value)
{
    OStringStream os;
    os << value;
    return os.str();
}

//- Refuses a word that is not one of the known ones
static void checkWord
(
    const dictionary& dict,
    const word& key,
    const word& value,
    const wordList& known
)
{
    if (!known.found(value))
    {
        // of two words none is near
        const std::string nearest
        (
            known.size() > 2
          ? "; the nearest one is " + nearestWord(value, known)
          : std::string()
        );
        FatalIOErrorInFunction(dict)
            << key << " " << value << " is not known; known are "
            << listed(known).c_str() << nearest.c_str() << exit(FatalIOError);
    }
}

} // End namespace Foam


std::string Foam::listed(const wordList& words)
{
    std::string text;
    for (const word& w : words)
    {
        text += (text.empty() ? "" : " ") + w;
    }
    return "(" + text + ")";
}


Foam::label Foam::letterChanges
(
    const std::string& a,
    const std::string& b
)
{
    labelList row(b.size() + 1);
    forAll(row, j)
    {
        row[j] = j;
    }
    for (size_t i = 1; i <= a.size(); ++i)
    {
        label diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j)
        {
            const label above = row[j];
            row[j] = min
            (
                min(row[j], row[j - 1]) + 1,
                diagonal + (std::tolower(a[i - 1]) != std::tolower(b[j - 1]))
            );
            diagonal = above;
        }
    }
    return row.last();
}


Foam::word Foam::nearestWord(const word& given, const wordList& known)
{
    word nearest;
    label least = labelMax;
    for (const word& candidate : known)
    {
        const label distance = letterChanges(given, candidate);
        if (distance < least)
        {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Type Foam::couplingProperties::take(const word& key, const Type& byDefault)
{
    if (found(key))
    {
        return get<Type>(key);
    }

    add(key, byDefault);

    defaults_ += (defaults_.empty() ? "" : ", ") + key + ' ' + text(byDefault);

    return byDefault;
}


void Foam::couplingProperties::checkEntries() const
{
    wordList known
    ({
        "overlap", "frozenFluid", "model", "voidFractionModel",
        "dragModel", "forceModels", "smoothingModel", "selfDisturbance",
        "ddtVoidFraction", "interpolation", "voidFractionMin",
        "allowNoBuoyancy", "verbose", "couplingInterval", "keepMapping",
        "quietFluid", "timeOffset", "writeFields"
    });

    const auto addCoeffs = [&known](const wordList& models)
    {
        for (const word& model : models)
        {
            known.append(model + "Coeffs");
        }
    };
    addCoeffs(dragModel::dictionaryConstructorTablePtr_->sortedToc());
    addCoeffs(voidFractionModel::dictionaryConstructorTablePtr_->sortedToc());
    addCoeffs(smoothingModel::dictionaryConstructorTablePtr_->sortedToc());
    addCoeffs(forceModel::dictionaryConstructorTablePtr_->sortedToc());

    for (const entry& e : *this)
    {
        const word& key = e.keyword();
        if (!known.found(key) && key != "FoamFile")
        {
            FatalIOErrorInFunction(*this)
                << "unknown entry " << key << "; the nearest known one is "
                << nearestWord(key, known) << exit(FatalIOError);
        }
    }
}


void Foam::couplingProperties::checkModel
(
    const word& key,
    const word& selected,
    const wordList& known
) const
{
    checkWord(*this, key, selected, known);

    for (const word& model : known)
    {
        if (model != selected && found(model + "Coeffs"))
        {
            FatalIOErrorInFunction(*this)
                << "unknown entry " << model << "Coeffs; " << key << " is "
                << selected << exit(FatalIOError);
        }
    }
}


void Foam::couplingProperties::checkForces() const
{
    wordList seen;
    for (const word& force : forces_)
    {
        checkWord
        (
            *this,
            "forceModels: force",
            force,
            forceModel::dictionaryConstructorTablePtr_->sortedToc()
        );
        if (seen.found(force))
        {
            FatalIOErrorInFunction(*this)
                << "forceModels lists " << force << " twice; a force counts"
                << " once" << exit(FatalIOError);
        }
        seen.append(force);
    }

    for
    (
        const word& force
      : forceModel::dictionaryConstructorTablePtr_->sortedToc()
    )
    {
        if (!has(force) && found(force + "Coeffs"))
        {
            FatalIOErrorInFunction(*this)
                << "unknown entry " << force << "Coeffs; forceModels are "
                << listed(forces_).c_str() << exit(FatalIOError);
        }
    }

    if (!modelA_ && has("pressureGradient"))
    {
        FatalIOErrorInFunction(*this)
            << "forceModels lists pressureGradient, but model is B, whose"
            << " drag carries it; leave it out or set model A"
            << exit(FatalIOError);
    }
    if (!modelA_ && has("viscous"))
    {
        FatalIOErrorInFunction(*this)
            << "forceModels lists viscous, but model is B, whose drag carries"
            << " it; leave it out or set model A" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingProperties::couplingProperties(const Time& runTime)
:
    IOdictionary
    (
        IOobject
        (
            "couplingProperties",
            runTime.constant(),
            runTime,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    )
{
    checkEntries();

    overlap_ = take<Switch>("overlap", Switch(true));

    const word model(take<word>("model", "A"));
    checkWord(*this, "model", model, {"A", "B"});
    modelA_ = (model == "A");

    checkModel
    (
        "voidFractionModel",
        take<word>("voidFractionModel", "exactOverlap"),
        voidFractionModel::dictionaryConstructorTablePtr_->sortedToc()
    );
    checkModel
    (
        "dragModel",
        take<word>("dragModel", "ergunWenYu"),
        dragModel::dictionaryConstructorTablePtr_->sortedToc()
    );
    checkModel
    (
        "smoothingModel",
        take<word>("smoothingModel", "none"),
        smoothingModel::dictionaryConstructorTablePtr_->sortedToc()
    );

    checkModel
    (
        "selfDisturbance",
        take<word>("selfDisturbance", "none"),
        selfDisturbanceModel::dictionaryConstructorTablePtr_->sortedToc()
    );
    frozenFluid_ = take<Switch>("frozenFluid", Switch(false));
    if (frozenFluid_ && get<word>("selfDisturbance") != "none")
    {
        FatalIOErrorInFunction(*this)
            << "selfDisturbance " << get<word>("selfDisturbance")
            << " with frozenFluid yes: particles do not disturb a frozen fluid;"
            << " set selfDisturbance none" << exit(FatalIOError);
    }

    forces_ = take<wordList>
    (
        "forceModels",
        modelA_ ? wordList({"pressureGradient", "buoyancy"})
                : wordList({"buoyancy"})
    );
    checkForces();

    ddt_ = take<word>("ddtVoidFraction", "auto");
    checkWord
    (
        *this,
        "ddtVoidFraction",
        ddt_,
        {"auto", "difference", "particleFlux", "none"}
    );

    interpolation_ = take<word>("interpolation", "mapped");
    checkWord
    (
        *this,
        "interpolation",
        interpolation_,
        {"mapped", "cell", "cellPoint"}
    );

    // the void fraction model reads and checks it
    take<scalar>("voidFractionMin", 0.2);

    keepMapping_ = numberFrom
    (
        *this, "keepMapping", take<scalar>("keepMapping", 1e-12), 0, 0.1,
        " radii"
    );
    quietFluid_ = numberFrom
    (
        *this, "quietFluid", take<scalar>("quietFluid", 1e-4), 0, 0.1,
        " of the largest speed"
    );

    allowNoBuoyancy_ = take<Switch>("allowNoBuoyancy", Switch(false));
    verbose_ = take<Switch>("verbose", Switch(false));

    writeFields_ = lookupOrDefault<wordList>("writeFields", wordList());
    for (const word& field : writeFields_)
    {
        checkWord(*this, "writeFields:", field, solidFields::known);
    }

    timeOffset_ = lookupOrDefault<scalar>("timeOffset", 0);
    interval_ = 0;
    if (found("couplingInterval"))
    {
        interval_ = numberAbove
        (
            *this, "couplingInterval", get<scalar>("couplingInterval"), 0,
            " s; leave it out to follow the DEM half"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingProperties::checkMesh(const polyMesh& mesh) const
{
    if (interpolation_ != "cellPoint")
    {
        return;
    }

    // OpenFOAM's values at the points are wrong where such a patch ends at
    // another rank's cells
    bool parted = false;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        parted = parted || isA<processorCyclicPolyPatch>(patch);
    }
    if (returnReduce(parted, orOp<bool>()))
    {
        FatalIOErrorInFunction(*this)
            << "interpolation cellPoint, but the two sides of a cyclic patch"
            << " lie on different ranks; set interpolation mapped or cell, or"
            << " keep them together: preservePatches, a constraint in"
            << " system/decomposeParDict"
            << exit(FatalIOError);
    }
}


Foam::couplingProperties::ddtType
Foam::couplingProperties::ddt(const bool sharp) const
{
    if (ddt_ == "none")
    {
        return ddtType::none;
    }
    if (ddt_ == "particleFlux" || (ddt_ == "auto" && !sharp))
    {
        return ddtType::particleFlux;
    }
    return ddtType::difference;
}
