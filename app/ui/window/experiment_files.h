#pragma once

#include "app/model/document.h"

#include <QObject>

#include <functional>

class QMenu;

namespace app {

class Notice;

/// What a window does with experiments: opens and saves them, as files, as text and by drag and drop, asks the learner
/// where something would be lost, and tells what was refused.
class ExperimentFiles : public QObject
{
    Q_OBJECT

public:
    /// Dialogs stand before `window`. All must outlive it.
    ExperimentFiles(Session &session, Notice &notice, QWidget &window);

    Document &document() { return m_document; }
    const Document &document() const { return m_document; }

    /// Opens a file. One that is refused is named with the reason, and nothing changes.
    void open(const QString &path);
    /// Writes the run so far. Returns whether it was written; a failure is shown.
    bool save(const QString &path);
    void askOpen();
    bool askSave();
    /// Into its own file, or into one that is asked for.
    bool saveOrAsk();
    /// The step as it is published.
    void startNew();
    /// Lists the files that were open last.
    void fillRecent(QMenu &menu);
    void copyAsText();
    void pasteText();
    /// Whether an event of a widget in the window is a file that is dragged over it; what is dropped is opened.
    bool takesDrop(const QObject *watched, QEvent &event);

    /// Asks about files that are not saved. Returns whether the window may close.
    bool mayClose();
    /// Does `deed`, at once or when the learner has agreed to lose what is not saved.
    void unlessLost(const std::function<void()> &deed);
    /// Does `deed`, which opens something. Returns whether it was opened; a refusal is shown.
    bool opens(const std::function<void()> &deed);

signals:
    /// Something for the status bar.
    void said(const QString &sentence);

private:
    void openRecent(const QString &path);

    Session &m_session;
    Notice &m_notice;
    QWidget &m_window;
    Document m_document;
};

}
