#include "app/model/branches.h"

#include "app/model/same_run.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

const Branch *Branches::find(int id) const
{
    const auto found =
        std::find_if(m_all.begin(), m_all.end(), [&](const Branch &one) { return one.id == id; });
    return found == m_all.end() ? nullptr : &*found;
}

const Branch *Branches::find(const sim::Script &script) const
{
    const auto found = std::find_if(m_all.begin(), m_all.end(),
                                    [&](const Branch &one) { return sameScript(*one.script, script); });
    return found == m_all.end() ? nullptr : &*found;
}

Branch *Branches::changeable(int id)
{
    const auto found =
        std::find_if(m_all.begin(), m_all.end(), [&](const Branch &one) { return one.id == id; });
    return found == m_all.end() ? nullptr : &*found;
}

QString Branches::ownName(const QString &name, int id) const
{
    const auto isTaken = [&](const QString &one) {
        return std::any_of(m_all.begin(), m_all.end(),
                           [&](const Branch &other) { return other.id != id && other.name == one; });
    };
    QString numbered = name;
    for (int i = 2; isTaken(numbered); ++i)
        numbered = QCoreApplication::translate("Branches", "%1 (%2)").arg(name, QString::number(i));
    return numbered;
}

void Branches::add(Branch branch, std::int64_t leftAt)
{
    while (const Branch *same = find(*branch.script)) {
        branch.isKept = branch.isKept || same->isKept;
        remove(same->id);
    }
    if (!branch.isNamed && leftAt > 0 && ownName(branch.name, branch.id) != branch.name)
        branch.name = QCoreApplication::translate("Branches", "%1 at frame %2")
                          .arg(branch.name, QString::number(leftAt));
    branch.name = ownName(branch.name, branch.id);
    m_all.push_back(std::move(branch));
}

void Branches::settle(const sim::Script &script)
{
    while (const Branch *same = find(script)) {
        m_own = {same->name, same->isNamed ? same->name : QString(), same->isKept, same->end};
        remove(same->id);
    }
}

void Branches::rename(int id, const QString &name)
{
    Branch *branch = changeable(id);
    if (!branch || name.trimmed().isEmpty())
        return;
    branch->name = ownName(name.simplified(), id);
    branch->isNamed = true;
}

void Branches::keep(int id, bool kept)
{
    if (Branch *branch = changeable(id))
        branch->isKept = kept;
    limit();
}

void Branches::remove(int id)
{
    std::erase_if(m_all, [&](const Branch &one) { return one.id == id; });
}

void Branches::limit()
{
    const auto passes = [](const Branch &one) { return !one.isKept; };
    while (std::count_if(m_all.begin(), m_all.end(), passes) > static_cast<std::ptrdiff_t>(mostPassing))
        m_all.erase(std::find_if(m_all.begin(), m_all.end(), passes));
}

std::int64_t firstDifferent(const sim::Script &a, const sim::Script &b)
{
    return sameRun(a, b) ? sim::firstDifference(a.input, b.input) : 0;
}

std::int64_t lastShared(const sim::Script &a, const sim::Script &b)
{
    const std::int64_t row = a.step.rowFrames;
    return std::max<std::int64_t>(0, firstDifferent(a, b) - 1) / row * row;
}

}
