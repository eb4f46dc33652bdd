#pragma once

#include "app/model/session.h"

#include <QObject>

#include <map>
#include <tuple>
#include <vector>

namespace app {

/// A step of a lesson, by their ids.
struct StepName
{
    QString lesson;
    QString step;
    friend bool operator==(const StepName &, const StepName &) = default;
    friend bool operator<(const StepName &a, const StepName &b)
    {
        return std::tie(a.lesson, a.step) < std::tie(b.lesson, b.step);
    }
};

/// The experiments of a session as files: which file each step's run is in, and whether that run has changed since.
class Document : public QObject
{
    Q_OBJECT

public:
    /// `session` must outlive it.
    explicit Document(Session &session, QObject *parent = nullptr);

    /// What the file of a step's run has.
    struct Saved
    {
        QString path;       ///< empty: no file
        sim::Script script; ///< as in the file, or as published
        Branches branches = {};
    };
    /// Of every step that was open.
    const std::map<StepName, Saved> &saved() const { return m_saved; }
    /// Goes on with what the document of another window knew.
    void setSaved(std::map<StepName, Saved> saved);

    /// The open step.
    StepName name() const;
    /// The file of its experiment; empty: it has none.
    QString path() const { return pathOf(name()); }
    QString pathOf(const StepName &name) const;
    /// Whether its run is another than its file has, or, without a file, than the step as it is published.
    bool isChanged() const { return isChanged(name()); }
    bool isChanged(const StepName &name) const;
    /// All steps that were open and whose runs have changed.
    std::vector<StepName> changed() const;
    /// The run of a step that is or was open.
    std::optional<Experiment> experimentOf(const StepName &name) const;

    /// Opens a file. @throws Refusal or sim::Error: refused, and nothing has changed
    void open(const QString &path);
    /// Opens an experiment that has no file. @throws sim::Error: refused, and nothing has changed
    void open(const Experiment &experiment);
    /// The step as it is published, without a file. It can be undone.
    void startNew();
    /// Writes the open run, which is in this file from now on. @throws Refusal: it was not written
    void save(const QString &path) { save(name(), path); }
    void save(const StepName &name, const QString &path);
    /// The run as it is needs no saving.
    void giveUp(const StepName &name);

signals:
    /// Another file, or whether the run has changed.
    void stateChanged();

private:
    void follow();
    void keep(const QString &path);
    void tell();

    Session &m_session;
    std::map<StepName, Saved> m_saved;
    QString m_toldPath;
    bool m_toldChanged = false;
};

}
