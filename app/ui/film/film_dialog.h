#pragma once

#include "app/ui/film/export_dialog.h"
#include "app/ui/film/film.h"

class QSpinBox;

namespace app {

class FilmName;
class FilmSize;

/// A dialog that asks for the settings of a film of the run and makes it.
class FilmDialog : public ExportDialog
{
    Q_OBJECT

public:
    /// The film shows the same content as `view`. All arguments must outlive it.
    FilmDialog(const Session &session, const SceneView &view, const Theme &theme, QWidget *parent = nullptr);

    /// Shows the dialog with the frames of the open run.
    void offer();

private:
    void start();
    FilmPlan plan() const;
    void showState() override;
    QString cancelled(std::int64_t frame) const override;

    const Session &m_session;
    const SceneView &m_view;
    const Theme &m_theme;
    QSpinBox *m_rate;
    FilmSize *m_size;
    FilmName *m_name;
};

}
