// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "checkedNumber.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static std::string text(const scalar x)
{
    std::ostringstream os;
    os << x;
    return os.str();
}


//- Refuses the value unless it is right
template<class Type>
static Type check
(
    const bool right,
    const dictionary& dict,
    const std::string& name,
    const Type value,
    const std::string& range,
    const std::string& more
)
{
    if (!right)
    {
        FatalIOErrorInFunction(dict)
            << name.c_str() << ' ' << value << " must " << range.c_str()
            << more.c_str() << exit(FatalIOError);
    }
    return value;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Other Functions * * * * * * * * * * * * * * //

Foam::scalar Foam::numberAbove
(
    const dictionary& dict,
    const std::string& name,
    const scalar value,
    const scalar limit,
    const std::string& more
)
{
    return check
    (
        value > limit, dict, name, value, "be above " + text(limit), more
    );
}


Foam::scalar Foam::numberFrom
(
    const dictionary& dict,
    const std::string& name,
    const scalar value,
    const scalar lo,
    const scalar hi,
    const std::string& more
)
{
    return check
    (
        value >= lo && value <= hi,
        dict,
        name,
        value,
        "be from " + text(lo) + " to " + text(hi),
        more
    );
}


Foam::scalar Foam::numberBetween
(
    const dictionary& dict,
    const std::string& name,
    const scalar value,
    const scalar lo,
    const scalar hi,
    const std::string& more
)
{
    return check
    (
        value > lo && value < hi,
        dict,
        name,
        value,
        "lie between " + text(lo) + " and " + text(hi),
        more
    );
}


Foam::label Foam::wholeNumberFrom
(
    const dictionary& dict,
    const std::string& name,
    const label value,
    const label lo,
    const label hi
)
{
    return check
    (
        value >= lo && value <= hi,
        dict,
        name,
        value,
        "be a whole number from " + std::to_string(lo) + " to "
      + std::to_string(hi),
        ""
    );
}
