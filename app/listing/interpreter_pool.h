#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace listing {

/// A pool of interpreters for one program text. Each thread takes a different interpreter while it runs the text.
template <class Type>
class InterpreterPool
{
public:
    /// Returns an interpreter that no other thread uses. Calls `make()` if there is none.
    template <class Make>
    std::unique_ptr<Type> take(const Make &make)
    {
        {
            const std::lock_guard lock(m_mutex);
            if (!m_idle.empty()) {
                std::unique_ptr<Type> interpreter = std::move(m_idle.back());
                m_idle.pop_back();
                return interpreter;
            }
        }
        return make();
    }
    void giveBack(std::unique_ptr<Type> interpreter)
    {
        const std::lock_guard lock(m_mutex);
        m_idle.push_back(std::move(interpreter));
    }

private:
    std::mutex m_mutex;
    std::vector<std::unique_ptr<Type>> m_idle;
};

}
