#pragma once

#include "app/ui/learn/fold_box.h"
#include "lessons/api/explanation.h"

namespace app {

/// A question about the mathematics of a step, with an answer that is folded until the learner unfolds it.
class WhyBox : public FoldBox
{
    Q_OBJECT

public:
    WhyBox(const lessons::Why &why, const Theme &theme, QWidget *parent = nullptr);

signals:
    /// Emitted when a formula of the answer highlights other things. Empty: nothing.
    void highlightsChanged(const std::vector<lessons::Highlight> &highlights);

protected:
    void fill() override;

private:
    const lessons::Why m_why; ///< a copy: the documents of a step can be read again
};

}
