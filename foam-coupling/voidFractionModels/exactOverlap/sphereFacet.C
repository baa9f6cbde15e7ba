// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "sphereFacet.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::sphereFacet::meeting Foam::sphereFacet::meet() const
{
    const scalar discSqr = R_*R_ - h_*h_;
    bool inside = true;
    for (const edge& e : edges_)
    {
        const vector from(e.start - centre_);
        const scalar d = e.outward & from;
        const scalar t1 = e.along & from;
        const scalar t = max(max(t1, -(t1 + e.length)), 0.0);

        if (d*d + t*t < discSqr)
        {
            return part;
        }
        inside = inside && d > 0;
    }

    return inside ? disc : apart;
}


Foam::scalar Foam::sphereFacet::solidAngle() const
{
    const vector a(edges_[0].start - centre_);
    const scalar magA = mag(a);

    vector b(edges_[1].start - centre_);
    scalar magB = mag(b);
    scalar sum = 0;

    for (label i = 2; i < edges_.size(); ++i)
    {
        const vector c(edges_[i].start - centre_);
        const scalar magC = mag(c);

        sum += std::atan2
        (
            std::abs(a & (b ^ c)),
            magA*magB*magC + (a & b)*magC + (a & c)*magB + (b & c)*magA
        );
        b = c;
        magB = magC;
    }

    return 2*sum;
}


Foam::scalar Foam::sphereFacet::crossed() const
{
    const scalar H = std::abs(h_);
    const scalar RSqr = R_*R_;
    const scalar discSqr = max(RSqr - H*H, 0.0);

    scalar moments = 0;     // twice the signed area within the disc
    scalar angles = 0;      // about the foot, of the parts beyond the disc
    scalar tilts = 0;       // second term of their solid angles

    for (const edge& e : edges_)
    {
        const vector from(e.start - centre_);
        const scalar signedD = e.outward & from;
        const scalar D = std::abs(signedD);
        if (D == 0)
        {
            continue;
        }

        const scalar sign = signedD > 0 ? 1 : -1;
        const scalar t1 = e.along & from;
        const scalar t2 = t1 + e.length;
        const scalar DSqr = D*D;

        const auto beyond = [&](const scalar from, const scalar to)
        {
            const scalar s1 = std::sqrt(H*H + DSqr + from*from);
            const scalar s2 = std::sqrt(H*H + DSqr + to*to);

            angles += sign*std::atan2(D*(to - from), DSqr + from*to);
            tilts += sign*std::atan2
            (
                H*D*(to*s1 - from*s2),
                DSqr*s1*s2 + H*H*from*to
            );
        };

        const scalar chord = std::sqrt(max(discSqr - DSqr, 0.0));
        const scalar enter = max(t1, -chord);
        const scalar leave = min(t2, chord);

        if (enter >= leave)
        {
            beyond(t1, t2);
            continue;
        }

        moments += signedD*(leave - enter);
        if (t1 < enter)
        {
            beyond(t1, enter);
        }
        if (leave < t2)
        {
            beyond(leave, t2);
        }
    }

    return
        H*moments/6
      + angles*H*(3*RSqr - H*H)/6
      - tilts*R_*RSqr/3;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::sphereFacet::volume() const
{
    if (h_ == 0)
    {
        return 0;
    }

    // seen from nearly within the plane only the sum over edges is exact
    const scalar result =
        meets_ == apart ? pow3(R_)/3*solidAngle() : crossed();

    return h_ > 0 ? result : -result;
}


Foam::scalar Foam::sphereFacet::takenOff() const
{
    if (meets_ == apart)
    {
        return 0;
    }

    const scalar H = std::abs(h_);
    const scalar RSqr = R_*R_;
    const scalar discSqr = RSqr - H*H;

    scalar moments = 0;     // twice the signed area within the disc
    scalar angles = 0;      // about the foot, of the parts within the disc
    scalar tilts = 0;       // second term of their solid angles
    bool inside = true;     // the foot in the polygon

    for (const edge& e : edges_)
    {
        const vector from(e.start - centre_);
        const scalar signedD = e.outward & from;
        const scalar D = std::abs(signedD);
        const scalar DSqr = D*D;
        inside = inside && signedD >= 0;

        if (DSqr >= discSqr)
        {
            continue;
        }

        const scalar t1 = e.along & from;
        const scalar chord = std::sqrt(discSqr - DSqr);
        const scalar enter = max(t1, -chord);
        const scalar leave = min(t1 + e.length, chord);
        if (enter >= leave)
        {
            continue;
        }

        const scalar sign = signedD >= 0 ? 1 : -1;
        const scalar s1 =
            enter == t1 ? std::sqrt(H*H + DSqr + t1*t1) : R_;
        const scalar s2 =
            leave == chord ? R_ : std::sqrt(H*H + DSqr + leave*leave);

        moments += signedD*(leave - enter);
        angles += sign*std::atan2(D*(leave - enter), DSqr + enter*leave);
        tilts += sign*std::atan2
        (
            H*D*(leave*s1 - enter*s2),
            DSqr*s1*s2 + H*H*enter*leave
        );
    }

    // sectors of the disc
    const scalar beyond =
        (inside ? constant::mathematical::twoPi : 0) - angles;

    const scalar result =
        H*moments/6
      - R_*RSqr/3*(angles - tilts)
      + beyond*(H*discSqr/6 - RSqr/3*(R_ - H));

    return h_ > 0 ? result : -result;
}
