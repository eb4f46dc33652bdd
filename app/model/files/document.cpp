#include "app/model/files/document.h"

#include "app/model/run/same_run.h"

#include <utility>

namespace app {

Document::Document(Session &session, QObject *parent) : QObject(parent), m_session(session)
{
    session.onChange(ChangeKind::step, this, &Document::follow);
    session.onChange(ChangeKind::run | ChangeKind::code, this, &Document::announce);
    follow();
}

StepName Document::name() const
{
    return {m_session.lesson().id, m_session.step().id};
}

QString Document::pathOf(const StepName &name) const
{
    const auto found = m_saved.find(name);
    return found == m_saved.end() ? QString() : found->second.path;
}

std::optional<Experiment> Document::experimentOf(const StepName &which) const
{
    return which == name() ? m_session.experiment() : m_session.experimentOf(which.lesson, which.step);
}

bool Document::isChanged(const StepName &which) const
{
    const auto found = m_saved.find(which);
    if (found == m_saved.end())
        return false;
    const Saved &kept = found->second;
    const auto differs = [&](const sim::Script &script, const Branches &branches,
                             const std::optional<QString> &draft) {
        return !sameScript(kept.script, script) || !sameMarked(kept.branches, branches) ||
               kept.draft != draft;
    };
    if (which == name())
        return differs(m_session.timeline().script(), m_session.comparisons().branches(),
                       m_session.run().draft());
    const std::optional<Experiment> left = m_session.experimentOf(which.lesson, which.step);
    return left && differs(left->script, left->branches, left->draft);
}

std::vector<StepName> Document::changed() const
{
    std::vector<StepName> names;
    for (const auto &[which, kept] : m_saved) {
        if (isChanged(which))
            names.push_back(which);
    }
    return names;
}

void Document::setSaved(std::map<StepName, Saved> saved)
{
    m_saved = std::move(saved);
    follow();
}

void Document::follow()
{
    m_saved.try_emplace(name(), Saved{{}, m_session.step().script()});
    announce();
}

void Document::announce()
{
    const bool isNew = path() != m_toldPath || isChanged() != m_toldChanged;
    m_toldPath = path();
    m_toldChanged = isChanged();
    if (isNew)
        emit stateChanged();
}

void Document::keep(const QString &path)
{
    m_saved.insert_or_assign(name(),
                             Saved{path, m_session.timeline().script(),
                                   m_session.comparisons().branches().marked(), m_session.run().draft()});
    announce();
}

void Document::open(const QString &path)
{
    m_session.open(readExperiment(path, m_session.library()));
    keep(path);
}

void Document::open(const Experiment &experiment)
{
    m_session.open(experiment);
    m_saved.insert_or_assign(name(), Saved{{}, m_session.step().script()});
    announce();
}

void Document::startNew()
{
    m_session.editor().startAfresh();
    keep({});
}

void Document::save(const StepName &which, const QString &path)
{
    const std::optional<Experiment> experiment = experimentOf(which);
    if (!experiment)
        return;
    writeExperiment(path, *experiment, m_session.library());
    m_saved.insert_or_assign(which, Saved{path, experiment->script, experiment->branches, experiment->draft});
    announce();
}

void Document::giveUp(const StepName &which)
{
    const std::optional<Experiment> experiment = experimentOf(which);
    const auto found = m_saved.find(which);
    if (!experiment || found == m_saved.end())
        return;
    found->second.script = experiment->script;
    found->second.branches = experiment->branches;
    found->second.draft = experiment->draft;
    announce();
}

}
