#pragma once

#include "app/model/files/document.h"

#include <QObject>

#include <functional>

class QDropEvent;
class QMenu;

namespace app {

class Notice;

/// Opens and saves the experiments of a window: as files, as text, and by drag and drop. It asks before changes would be
/// lost, shows errors, and names the file in the title of the window.
class ExperimentFiles : public QObject
{
    Q_OBJECT

public:
    /// Dialogs belong to `window`. All arguments must outlive it.
    ExperimentFiles(Session &session, Notice &notice, QWidget &window);

    Document &document() { return m_document; }
    const Document &document() const { return m_document; }

    /// Opens an experiment, or announces that a lesson was chosen. If a file is invalid, the reason is shown and nothing
    /// changes.
    void open(const QString &path);
    /// Writes the run so far. Returns whether it was written; a failure is shown.
    bool save(const QString &path);
    /// Asks for a file, and opens it.
    void askOpen();
    /// Asks for a file, and saves to it. Returns whether it was written.
    bool askSave();
    /// Saves to the experiment's own file, or asks for one. Returns whether it was written.
    bool saveOrAsk();
    /// Opens the step as it was published.
    void startNew();
    /// Fills a menu with the files that were open last.
    void fillRecent(QMenu &menu);
    void copyAsText();
    void pasteText();

    /// Asks about files with unsaved changes. Returns whether the window may close.
    bool mayClose();
    /// Runs `action`, but asks first if unsaved changes would be lost.
    void unlessLost(const std::function<void()> &action);
    /// Runs `action`, which opens something. Returns whether that succeeded; an error is shown.
    bool opens(const std::function<void()> &action);

    bool eventFilter(QObject *window, QEvent *event) override;

signals:
    /// A lesson without C++ was chosen: a folder or a file.
    void lessonChosen(const QString &path);

private:
    void showTitle();
    /// Accepts a file that is dragged over the window, and opens it when it is dropped. Returns false if the event is
    /// about something else.
    bool takesDrop(QDropEvent &event);
    /// Opens a file, but asks first if unsaved changes would be lost. A lesson takes nothing away.
    void openOrAsk(const QString &path);
    void openRecent(const QString &path);

    Session &m_session;
    Notice &m_notice;
    QWidget &m_window;
    Document m_document;
};

}
