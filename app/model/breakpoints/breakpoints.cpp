#include "app/model/breakpoints/breakpoints.h"

#include <algorithm>

namespace app {

const Breakpoint *Breakpoints::find(int id) const
{
    const auto found =
        std::find_if(m_open.begin(), m_open.end(), [id](const Breakpoint &one) { return one.id == id; });
    return found == m_open.end() ? nullptr : &*found;
}

Breakpoint *Breakpoints::its(int id)
{
    const auto found =
        std::find_if(m_open.begin(), m_open.end(), [id](const Breakpoint &one) { return one.id == id; });
    return found == m_open.end() ? nullptr : &*found;
}

const Breakpoint *Breakpoints::at(const CodePlace &place) const
{
    const auto found =
        std::find_if(m_open.begin(), m_open.end(), [&](const Breakpoint &one) { return one.place == place; });
    return found == m_open.end() ? nullptr : &*found;
}

bool Breakpoints::isAnyOn() const
{
    return std::any_of(m_open.begin(), m_open.end(), [](const Breakpoint &one) { return one.isOn; });
}

void Breakpoints::open(const QString &key)
{
    if (key == m_key)
        return;
    m_closed[m_key] = std::move(m_open);
    m_key = key;
    m_open = std::move(m_closed[key]);
    emit changed();
}

bool Breakpoints::toggle(const CodePlace &place)
{
    const Breakpoint *there = at(place);
    if (there)
        std::erase_if(m_open, [&](const Breakpoint &one) { return one.place == place; });
    else
        m_open.push_back({++m_last, place, {}, true});
    emit changed();
    return !there;
}

void Breakpoints::add(const QString &condition)
{
    m_open.push_back({++m_last, std::nullopt, condition, true});
    emit changed();
}

void Breakpoints::setCondition(int id, const QString &condition)
{
    Breakpoint *one = its(id);
    if (!one || one->condition == condition)
        return;
    one->condition = condition;
    emit changed();
}

void Breakpoints::setOn(int id, bool on)
{
    Breakpoint *one = its(id);
    if (!one || one->isOn == on)
        return;
    one->isOn = on;
    emit changed();
}

void Breakpoints::remove(int id)
{
    if (std::erase_if(m_open, [id](const Breakpoint &one) { return one.id == id; }) > 0)
        emit changed();
}

}
