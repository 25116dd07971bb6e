/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "bodyExchange.H"
#include "rankMail.H"
#include "UIndirectList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::bodyExchange::setMessages(const packedBodies& packed)
{
    const auto room =
        [&](const labelListList& bodies, List<scalarList>& messages)
    {
        messages.setSize(bodies.size());
        forAll(bodies, rank)
        {
            label n = 0;
            for (const label b : bodies[rank])
            {
                n += packed.nShared(b);
            }
            messages[rank].setSize(n);
        }
    };
    room(send_, out_);
    room(receive_, in_);
}


void Foam::dem::bodyExchange::post(const packedBodies& packed)
{
    const auto bytes = [](UList<scalar>& message)
    {
        return reinterpret_cast<char*>(message.data());
    };

    firstRequest_ = Pstream::nRequests();
    forAll(in_, rank)
    {
        if (in_[rank].size())
        {
            UIPstream::read
            (
                Pstream::commsTypes::nonBlocking,
                rank,
                bytes(in_[rank]),
                in_[rank].byteSize()
            );
        }
    }
    forAll(out_, rank)
    {
        scalar* to = out_[rank].data();
        for (const label b : send_[rank])
        {
            to = packed.share(b, to);
        }
        if (out_[rank].size())
        {
            UOPstream::write
            (
                Pstream::commsTypes::nonBlocking,
                rank,
                bytes(out_[rank]),
                out_[rank].byteSize()
            );
        }
    }
}


void Foam::dem::bodyExchange::collect(packedBodies& packed)
{
    Pstream::waitRequests(firstRequest_);
    forAll(in_, rank)
    {
        const scalar* from = in_[rank].cdata();
        for (const label b : receive_[rank])
        {
            from = packed.receive(b, from);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::bodyExchange::take(const bodies& own)
{
    forAll(own_, k)
    {
        all_->setState(own_[k], own.record(k));
    }
    drag_.set(own.drag, own_, all_->size());
    all_->drag = drag_.acts() ? &drag_ : nullptr;
    all_->recordDrag = own.recordDrag;
}


void Foam::dem::bodyExchange::giveBack(bodies& own) const
{
    forAll(own_, k)
    {
        own.setState(k, all_->record(own_[k]));
    }
    own.dragGiven = UIndirectList<vector>
    (
        all_->dragGiven,
        all_->dragGiven.size() ? own_ : labelList()
    );
}


void Foam::dem::bodyExchange::copy(labelUList& ofAll) const
{
    List<DynamicList<label>> out(send_.size());
    forAll(send_, rank)
    {
        for (const label b : send_[rank])
        {
            out[rank].append(ofAll[b]);
        }
    }
    const List<List<label>> in(swapRecords(out));
    forAll(receive_, rank)
    {
        forAll(receive_[rank], k)
        {
            ofAll[receive_[rank][k]] = in[rank][k];
        }
    }
}


// ************************************************************************* //
