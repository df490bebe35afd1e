package faultline.engine.session;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;

/**
 * The requests to a session, which its thread executes between two ticks, and the answers to them, which are sent when
 * a frame that shows their effect is published. Any thread may add a request; the rest is for the session's thread.
 */
final class SessionRequests {

    private final Queue<Runnable> requests = new ConcurrentLinkedQueue<>();
    private final Queue<Runnable> answers = new ArrayDeque<>();

    void add(Runnable request) {
        requests.add(request);
    }

    boolean isEmpty() {
        return requests.isEmpty();
    }

    /** Executes all requests in their order, given what handles the exception of one. */
    void execute(Consumer<RuntimeException> onFailure) {
        for (Runnable request = requests.poll(); request != null; request = requests.poll()) {
            try {
                request.run();
            } catch (RuntimeException e) {
                onFailure.accept(e);
            }
        }
    }

    void addAnswer(Runnable answer) {
        answers.add(answer);
    }

    boolean hasAnswers() {
        return !answers.isEmpty();
    }

    /** Sends all answers in their order. */
    void sendAnswers() {
        for (Runnable answer = answers.poll(); answer != null; answer = answers.poll()) {
            answer.run();
        }
    }
}
