#pragma once

#include "app/ui/theme/theme.h"

#include <QTimer>
#include <QWidget>

#include <vector>

namespace app {

class ParameterRow;
class Session;

/// The first parameters of a step in a bar, as many as fit.
class FocusParameters : public QWidget
{
    Q_OBJECT

public:
    static constexpr std::size_t most = 3;

    FocusParameters(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// Returns the rows of the first parameters, including those that do not fit.
    const std::vector<ParameterRow *> &rows() const { return m_rows; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {0, 0}; }

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void open();
    void refresh();
    void fit();

    Session &m_session;
    const Theme &m_theme;
    std::vector<ParameterRow *> m_rows;
    QTimer m_refreshTimer; ///< limits how often numbers change while the run plays
};

}
