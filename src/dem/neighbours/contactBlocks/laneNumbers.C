/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "laneNumbers.H"
#include "error.H"

#include <cstdint>
#include <cstring>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Number>
void Foam::dem::laneNumbers<Number>::grow(const label n)
{
    constexpr std::size_t line = 64;
    const char* const before = static_cast<char*>(memory_.get());
    const std::size_t begin =
        first_ ? reinterpret_cast<const char*>(first_) - before : 0;

    // A little to spare for the next time
    room_ = n + n/16;
    void* const memory =
        std::realloc(memory_.get(), room_*sizeof(Number) + line);
    if (!memory)
    {
        FatalErrorInFunction
            << "No memory for " << room_ << " numbers of contacts"
            << exit(FatalError);
    }
    memory_.release();
    memory_.reset(memory);

    char* const now = static_cast<char*>(memory);
    const std::size_t first = (-reinterpret_cast<std::uintptr_t>(now)) % line;
    if (first != begin)
    {
        std::memmove(now + first, now + begin, set_*sizeof(Number));
    }
    first_ = reinterpret_cast<Number*>(now + first);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Number>
void Foam::dem::laneNumbers<Number>::setSize(const label n)
{
    if (n > room_)
    {
        grow(n);
    }

    // What no contact has written is read and then left out: it must be a
    // number
    if (n > set_)
    {
        std::memset(first_ + set_, 0, (n - set_)*sizeof(Number));
        set_ = n;
    }
}


// * * * * * * * * * * * * * * * * Instances * * * * * * * * * * * * * * * * //

template class Foam::dem::laneNumbers<double>;
template class Foam::dem::laneNumbers<float>;


// ************************************************************************* //
