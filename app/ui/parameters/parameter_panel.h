#pragma once

#include "app/model/session/open_run.h"
#include "app/model/session/run_editor.h"
#include "app/ui/dock/number_pace.h"
#include "app/ui/parameters/preset_gallery.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

#include <vector>

class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace app {

class ParameterRow;

/// A panel with the parameters of the open step, under its own title. It shows four parameters, and the rest
/// if there is room or the learner unfolds them.
class ParameterPanel : public QWidget
{
    Q_OBJECT

public:
    ParameterPanel(const OpenRun &run, RunEditor &editor, const Playback &playback, const Theme &theme,
                   QWidget *parent = nullptr);

    /// Sets how the presets of a step are painted. Without a painter there is no gallery.
    void setPresetPainter(PresetPainter painter);

    /// Marks the rows of parameters that are highlighted, until this is called again. If one is folded, the button that
    /// unfolds it looks pressed.
    void setHighlights(const std::vector<lessons::Highlight> &highlights);

    static constexpr int slack = 8; ///< px by which the margin at the bottom may be smaller

    /// Returns the size for the title and the rows. Rows that unfolded by themselves count as folded.
    QSize sizeHint() const override;
    /// Returns the height from which all parameters are unfolded automatically, px.
    int fullHeight() const;
    QSize minimumSizeHint() const override;

signals:
    /// Emitted when sizeHint().height() changes.
    void wantedHeightChanged();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *makeTitle();
    void makeDisclosure();
    void showPresets();
    void open();
    /// Returns the ids of the parameters that affect the scene.
    QStringList offered() const;
    /// Returns whether the parameters have other names, helps or units than the rows: their document was saved.
    bool hasOtherTexts() const;
    void follow(const Change &change);
    void addRows();
    void alignColumns();
    void nameRest();
    void refresh();
    void refreshNow();
    void unfold(bool all);
    void drawArrow();
    void unfoldIfRoom();
    void showMarked();
    int heightOf(std::size_t rows, bool disclosure) const;

    const OpenRun &m_run;
    RunEditor &m_editor;
    const Theme &m_theme;
    QToolButton *m_presets = nullptr;
    QToolButton *m_resetAll = nullptr;
    PresetGallery *m_gallery = nullptr;
    QScrollArea *m_area = nullptr;
    QVBoxLayout *m_column = nullptr;
    QToolButton *m_more = nullptr;
    QStringList m_offered; ///< ids of the rows that are shown
    QStringList m_marked;  ///< ids of the rows that are marked
    QString m_rest;        ///< the names of the parameters that m_more unfolds
    std::vector<ParameterRow *> m_rows;
    NumberPace m_pace;
    bool m_placed = false; ///< whether it has been given a size
    bool m_unfolded = false;
    bool m_chosen = false; ///< whether the learner folded or unfolded the rest by hand
};

}
