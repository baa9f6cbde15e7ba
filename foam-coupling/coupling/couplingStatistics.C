// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "couplingStatistics.H"

#include "OStringStream.H"
#include "error.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "foamVersion.H"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- An entry's stream as a number, true/false or text
static nlohmann::json value(const entry& e)
{
    const ITstream& is = e.stream();
    if (is.size() == 1)
    {
        if (is[0].isLabel())
        {
            return is[0].labelToken();
        }
        if (is[0].isNumber())
        {
            return is[0].number();
        }
        if (is[0].isWord())
        {
            const word text(is[0].wordToken());
            if (text == "yes" || text == "true" || text == "on")
            {
                return true;
            }
            if (text == "no" || text == "false" || text == "off")
            {
                return false;
            }
            return text;
        }
    }

    // a list without its size
    OStringStream os;
    forAll(is, i)
    {
        const bool size =
            is[i].isLabel() && i + 1 < is.size()
         && is[i + 1] == token::BEGIN_LIST;
        if (!size)
        {
            os << (os.str().empty() ? "" : " ") << is[i];
        }
    }
    return os.str();
}


static nlohmann::json toJson(const dictionary& dict)
{
    nlohmann::json j = nlohmann::json::object();
    for (const entry& e : dict)
    {
        const std::string& key = e.keyword();
        if (key == "FoamFile")
        {
            continue;
        }
        j[key] = e.isDict() ? toJson(e.dict()) : value(e);
    }
    return j;
}


//- Of all ranks the largest. Collective.
static scalar most(scalar value)
{
    return returnReduce(value, maxOp<scalar>());
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingStatistics::warn(const std::string& text)
{
    if (std::find(warnings.begin(), warnings.end(), text) == warnings.end())
    {
        warnings.push_back(text);
        Info<< "clayFoam: warning: " << text.c_str() << endl;
    }
}


void Foam::couplingStatistics::write
(
    const fileName& file,
    const dictionary& settings
) const
{
    nlohmann::json j;
    j["program"] = "clayFoam";
    j["openfoam"] = "v" + std::to_string(foamVersion::api);
    j["cfd_s"] = most(solving);
    j["exchange_s"] = most(exchange);
    j["waiting_s"] = most(waiting);
    j["mapping_s"] = most(mapping);
    j["cfd_cpu_s"] = most(solvingCpu);
    j["mapping_cpu_s"] = most(mappingCpu);
    j["output_s"] = most(output);
    j["cfd_steps"] = steps;
    j["exchanges"] = exchanges;
    j["bytes_sent"] = returnReduce(bytesSent, sumOp<double>());
    j["quiet_intervals"] = quietIntervals;
    j["exchanges_without_mapping"] = keptMaps;
    j["particles_mapped"] = returnReduce(mapped, sumOp<scalar>());
    j["stiff_exchanges"] = stiffExchanges;
    j["courant_max"] = most(courantMax);
    j["reynolds_max"] = most(reynoldsMax);
    j["max_momentum_residual"] = momentumResidual;
    j["max_void_fraction_volume_error"] = voidFractionError;
    j["sphere_weight_sum_min"] = -most(-weightSumMin);
    j["sphere_weight_sum_max"] = most(weightSumMax);
    j["clipped_volume_max"] = clippedVolume;
    j["drag_change_mean"] = dragSum > VSMALL ? dragChange/dragSum : 0;
    j["uncarried_force_max"] = uncarried;
    j["cells_crossed_max"] = crossing;
    j["interval_over_relaxation_max"] = relaxations;
    j["cell_wave_correlation"] = waveCorrelation;
    j["cell_wave_amplitude"] = waveAmplitude;
    j["warnings"] = warnings;
    j["settings"] = toJson(settings);

    if (Pstream::master())
    {
        std::ofstream os(file);
        os << j.dump(2) << std::endl;
        if (!os)
        {
            FatalErrorInFunction
                << "cannot write " << file << exit(FatalError);
        }
    }
}
