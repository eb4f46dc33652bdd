#pragma once

#include "app/ui/film/film.h"

#include <QDialog>
#include <QTimer>

class QPushButton;
class QSpinBox;

namespace app {

class ExportProgress;
class FilmName;
class FilmSize;
class FrameRange;

/// A dialog that asks for the settings of a film of the run and makes it while the window stays usable.
class FilmDialog : public QDialog
{
    Q_OBJECT

public:
    /// The film shows the same content as `view`. All arguments must outlive it.
    FilmDialog(const Session &session, const SceneView &view, const Theme &theme, QWidget *parent = nullptr);

    /// Shows the dialog with the frames of the open run.
    void offer();
    bool isMaking() const { return m_film != nullptr; }
    /// Returns the message at the bottom: the progress, or how the film ended.
    QString message() const;
    void done(int result) override;

private:
    QWidget *fields();
    QWidget *buttons();
    void start();
    void clearMessage();
    void goOn();
    void stop();
    void end(const QString &sentence);
    void showState();
    FilmPlan plan() const;

    const Session &m_session;
    const SceneView &m_view;
    const Theme &m_theme;
    FrameRange *m_range;
    QSpinBox *m_rate;
    FilmSize *m_size;
    FilmName *m_name;
    QWidget *m_fields; ///< all settings
    ExportProgress *m_progress;
    QPushButton *m_make;
    QPushButton *m_stop;
    std::unique_ptr<Film> m_film;
    QString m_making; ///< name of the film that is being made
    QTimer m_next;    ///< for the next picture; active while a film is made
};

}
