package faultline.gui.edit;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Tasks that wait until the run has answered all commands that were sent before them. Commands that are sent after such
 * a task wait for it, so that all are executed in order. Event dispatch thread only.
 */
final class AnswerQueue {

    private final Deque<Runnable> tasks = new ArrayDeque<>();
    private int unanswered;

    /** Runs what sends commands, at once unless a task is waiting. */
    void send(Runnable sender) {
        if (tasks.isEmpty()) {
            unanswered++;
            sender.run();
        } else {
            tasks.add(() -> {
                unanswered++;
                sender.run();
            });
        }
    }

    /** Records that the run has answered what one task has sent, and runs the tasks that need not wait any longer. */
    void answered() {
        unanswered--;
        runTasks();
    }

    /** Runs a task at once if all commands have been answered, and otherwise as soon as they are. */
    void runWhenAnswered(Runnable task) {
        tasks.add(task);
        runTasks();
    }

    private void runTasks() {
        while (unanswered == 0 && !tasks.isEmpty()) {
            tasks.remove().run();
        }
    }

    /** Forgets all tasks and commands, because another run has taken the place of the one that would answer. */
    void clear() {
        tasks.clear();
        unanswered = 0;
    }
}
