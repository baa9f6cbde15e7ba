// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "viscosityLaw.H"

#include "Function1.H"
#include "dimensionedScalar.H"

#include <memory>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static word transportModel(const dictionary& dict)
{
    return dict.lookupOrDefault<word>("transportModel", "Newtonian");
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityLaw::viscosityLaw(const dictionary& transportProperties)
:
    model_(transportModel(transportProperties))
{
    const dictionary& coeffs =
        transportProperties.optionalSubDict(model_ + "Coeffs");

    const auto number = [&](const word& name, const dimensionSet& dims)
    {
        return dimensionedScalar(name, dims, coeffs).value();
    };
    const auto positive = [&](const word& name)
    {
        const scalar value = number(name, dimViscosity);
        if (!(value > 0))
        {
            FatalIOErrorInFunction(transportProperties)
                << name << ' ' << value << " must be above 0"
                << exit(FatalIOError);
        }
        return value;
    };

    if (model_ == "Newtonian")
    {
        const scalar nu = positive("nu");
        nu_ = [=](const scalar) { return nu; };
    }
    else if (model_ == "HerschelBulkley")
    {
        const scalar nu0 = positive("nu0"), k = number("k", dimViscosity);
        const scalar n = number("n", dimless);
        const scalar tau0 = number("tau0", dimViscosity/dimTime);
        nu_ = [=](const scalar rate)
        {
            return min(nu0, (tau0 + k*pow(rate, n))/max(rate, VSMALL));
        };
    }
    else if (model_ == "powerLaw")
    {
        const scalar k = positive("k"), n = number("n", dimless);
        const scalar least = positive("nuMin"), most = positive("nuMax");
        nu_ = [=](const scalar rate)
        {
            return max(least, min(most, k*pow(max(rate, SMALL), n - 1)));
        };
    }
    else if (model_ == "CrossPowerLaw")
    {
        const scalar nu0 = positive("nu0"), nuInf = positive("nuInf");
        const scalar m = number("m", dimTime), n = number("n", dimless);
        nu_ = [=](const scalar rate)
        {
            return (nu0 - nuInf)/(1 + pow(m*rate, n)) + nuInf;
        };
    }
    else if (model_ == "BirdCarreau")
    {
        const scalar nu0 = positive("nu0"), nuInf = positive("nuInf");
        const scalar k = number("k", dimTime), n = number("n", dimless);
        const scalar a = coeffs.found("a") ? number("a", dimless) : 2;
        nu_ = [=](const scalar rate)
        {
            return nuInf + (nu0 - nuInf)*pow(1 + pow(k*rate, a), (n - 1)/a);
        };
    }
    else if (model_ == "Casson")
    {
        const scalar m = positive("m");
        const scalar tau0 = number("tau0", dimViscosity/dimTime);
        const scalar least = positive("nuMin"), most = positive("nuMax");
        nu_ = [=](const scalar rate)
        {
            return max
            (
                least,
                min(most, sqr(sqrt(tau0/max(rate, VSMALL)) + sqrt(m)))
            );
        };
    }
    else if (model_ == "strainRateFunction")
    {
        std::shared_ptr<Function1<scalar>> f
        (
            Function1<scalar>::New("function", coeffs).ptr()
        );
        nu_ = [=](const scalar rate) { return f->value(rate); };
    }
    else
    {
        FatalIOErrorInFunction(transportProperties)
            << "transportModel " << model_ << " is not known; known are"
            << " Newtonian, HerschelBulkley, powerLaw, CrossPowerLaw,"
            << " BirdCarreau, Casson and strainRateFunction"
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
