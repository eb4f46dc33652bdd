#pragma once

#include "app/model/session.h"
#include "app/ui/panels/preset_gallery.h"
#include "app/ui/theme/theme.h"

#include <QElapsedTimer>
#include <QWidget>

#include <vector>

class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace app {

class ParameterRow;

/// The parameters of the open step, under a title of their own: four, and the rest when there is room or the
/// learner asks.
class ParameterPanel : public QWidget
{
    Q_OBJECT

public:
    ParameterPanel(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// How the presets of steps that have some are painted; without it there is no gallery.
    void setPresetPainter(PresetPainter painter);

    /// The height that shows what is unfolded, with the title.
    QSize sizeHint() const override;
    /// The height from which every parameter is shown unasked.
    int fullHeight() const;
    QSize minimumSizeHint() const override;

signals:
    /// sizeHint().height() is another.
    void wantedHeightChanged(int height);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *makeTitle();
    void makePresets(QWidget *title);
    void makeDisclosure();
    void showPresets();
    void open();
    /// The ids of the parameters that the scene has a use for.
    QStringList offered() const;
    void followEffects();
    void addRows();
    void alignColumns();
    void nameRest();
    void refresh();
    void refreshNow();
    void unfold(bool all);
    void unfoldIfRoom();
    int heightOf(std::size_t rows, bool disclosure) const;
    void dress();

    Session &m_session;
    const Theme &m_theme;
    QToolButton *m_presets = nullptr;
    QToolButton *m_resetAll = nullptr;
    PresetGallery *m_gallery = nullptr;
    QScrollArea *m_area = nullptr;
    QVBoxLayout *m_column = nullptr;
    QToolButton *m_more = nullptr;
    QStringList m_offered; ///< as the rows show
    QString m_rest;        ///< the names of the parameters that m_more unfolds
    std::vector<ParameterRow *> m_rows;
    QElapsedTimer m_sinceRefresh;
    bool m_placed = false; ///< whether it was given a size
    bool m_unfolded = false;
    bool m_chosen = false; ///< whether the learner folded or unfolded the rest
};

}
