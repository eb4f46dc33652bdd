#include "app/model/run/branches.h"

#include "app/model/catalog/lists.h"
#include "app/model/run/same_run.h"
#include "app/model/text/phrases.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace app {

const Branch *Branches::find(int id) const
{
    return findById(m_all, id);
}

const Branch *Branches::find(const sim::Script &script) const
{
    const auto found = std::find_if(m_all.begin(), m_all.end(),
                                    [&](const Branch &one) { return sameScript(*one.script, script); });
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
        numbered = withRemark(name, QString::number(i));
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
    Branch *branch = findById(m_all, id);
    if (!branch || name.trimmed().isEmpty())
        return;
    branch->name = ownName(name.simplified(), id);
    branch->isNamed = true;
}

void Branches::keep(int id, bool kept)
{
    if (Branch *branch = findById(m_all, id))
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

Branches Branches::marked() const
{
    Branches marked;
    std::copy_if(m_all.begin(), m_all.end(), std::back_inserter(marked.m_all),
                 [](const Branch &one) { return one.isNamed || one.isKept; });
    if (!m_own.name.isEmpty() || m_own.isKept)
        marked.m_own = m_own;
    return marked;
}

Branches Branches::withScripts(const std::function<sim::Script(const sim::Script &)> &change) const
{
    Branches changed = *this;
    for (Branch &one : changed.m_all)
        one.script = std::make_shared<const sim::Script>(change(*one.script));
    return changed;
}

Branches Branches::renumbered(int &last) const
{
    Branches renumbered = *this;
    for (Branch &one : renumbered.m_all)
        one.id = ++last;
    return renumbered;
}

bool sameMarked(const Branches &a, const Branches &b)
{
    const Branches of = a.marked();
    const Branches with = b.marked();
    const auto isSame = [](const Branch &one, const Branch &other) {
        return one.name == other.name && one.isNamed == other.isNamed && one.isKept == other.isKept &&
               (one.script == other.script || sameScript(*one.script, *other.script));
    };
    return of.own().name == with.own().name && of.own().isKept == with.own().isKept &&
           std::equal(of.all().begin(), of.all().end(), with.all().begin(), with.all().end(), isSame);
}

std::int64_t firstDifferent(const sim::Script &a, const sim::Script &b)
{
    return sameRun(a, b) ? sim::firstDifference(a.input, b.input) : 0;
}

std::int64_t lastShared(const sim::Script &a, const sim::Script &b)
{
    const std::int64_t output = a.step.framesPerOutput;
    return std::max<std::int64_t>(0, firstDifferent(a, b) - 1) / output * output;
}

}
