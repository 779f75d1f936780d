#pragma once

#include <LinearMath/btThreads.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace bullet_buoyancy::scenes {

/// A task scheduler for Bullet with threads that live as long as it does, so that it serves a Bullet that was
/// built without one. Pieces of work are dealt out in turn. Threads look out for work for about a millisecond
/// before they sleep, as Bullet's own do. While it lives, it is Bullet's.
class ThreadScheduler final : public btITaskScheduler {
public:
    explicit ThreadScheduler(int threads) : btITaskScheduler("threads"), m_threads(threads) {
        btSetTaskScheduler(this);
        for (int i = 1; i < threads; ++i)
            m_workers.emplace_back([this, i] { work(i); });
    }
    ~ThreadScheduler() override {
        giveWork({});
        for (std::thread& worker : m_workers)
            worker.join();
        btSetTaskScheduler(nullptr);
    }

    int getMaxNumThreads() const override { return m_threads; }
    int getNumThreads() const override { return m_threads; }
    void setNumThreads(int) override {}

    void parallelFor(int begin, int end, int grain, const btIParallelForBody& body) override {
        const Work work{&body, begin, end, grain};
        giveWork(work);
        doShare(work, 0);
        while (m_busy > 0)
            std::this_thread::yield();
        m_handedOver += (end - begin + grain - 1) / grain > 1 && m_threads > 1;
    }
    btScalar parallelSum(int begin, int end, int, const btIParallelSumBody& body) override {
        return body.sumLoop(begin, end);
    }

    /// Loops in which others than the caller's thread had a part.
    int handedOver() const { return m_handedOver; }

private:
    struct Work {
        const btIParallelForBody* body = nullptr;  // null: the end
        int begin = 0, end = 0, grain = 1;
    };

    void giveWork(const Work& work) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_work = work;
        m_busy = m_threads - 1;
        ++m_round;
        m_changed.notify_all();
    }

    void doShare(const Work& work, int thread) const {
        for (int i = work.begin + thread * work.grain; i < work.end; i += m_threads * work.grain)
            work.body->forLoop(i, std::min(i + work.grain, work.end));
    }

    void work(int thread) {
        std::unique_lock<std::mutex> lock(m_mutex);
        for (int done = 0;; ++done) {
            m_changed.wait(lock, [&] { return m_round > done; });
            const Work work = m_work;
            if (!work.body) return;
            lock.unlock();
            doShare(work, thread);
            --m_busy;
            lookOut(done + 1);
            lock.lock();
        }
    }

    void lookOut(int done) const {
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(1);
        while (m_round <= done && std::chrono::steady_clock::now() < end)
            std::this_thread::yield();
    }

    int m_threads;
    std::vector<std::thread> m_workers;
    std::mutex m_mutex;  // of the work
    std::condition_variable m_changed;
    Work m_work;
    std::atomic<int> m_round{0}, m_busy{0};
    int m_handedOver = 0;
};

}  // namespace bullet_buoyancy::scenes
