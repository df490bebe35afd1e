package faultline.external;

import faultline.io.MessageText;
import faultline.io.ShutdownHooks;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * A child process with which lines are exchanged. The calling thread polls the child's output and never blocks in a
 * read, so a silent child, or a descendant that keeps the pipe open, cannot block it. A daemon thread drains the
 * child's standard error; another ends a child that does not read, which would block a write; a third detects whether a
 * silent child has closed its output; a fourth closes the child.
 */
final class ChildProcess implements AutoCloseable {

    /** The time for which an answer is awaited without sleeping, nanoseconds. */
    private static final long SPIN = 300_000;

    private static final long LONGEST_SLEEP = 1_000_000;
    /**
     * The maximum time that is counted between two checks of the child, nanoseconds; if the next check is later, the
     * machine was busy.
     */
    private static final long LONGEST_WAIT = 10_000_000;

    /** The time after which the program checks whether the child has closed its output, nanoseconds. */
    private static final long SILENCE = 1_000_000_000;

    private static final long WRITE_CHECK_PERIOD = 200_000_000;

    private static final int KEPT_LINES = 20;
    /** The length of a kept line, characters. */
    private static final int MAX_KEPT_LENGTH = 400;

    /** The length of a line that is shown, characters. */
    private static final int MAX_SHOWN_LENGTH = 10_000;

    private static final long GRACE_SECONDS = 2;

    private final Process process;
    private final DetachedProcesses detached = new DetachedProcesses();
    private final OutputStream input;
    private final ChildOutput output;
    private final Deque<String> errorLines = new ArrayDeque<>();
    private final Thread errorReader;
    private final Thread writeGuard;
    /** Closes this child; not started before its end begins. */
    private final Thread closer = daemon("faultline-child-close", this::end);

    private final Thread exitHook = new Thread(this::endWithProgram);
    private final Consumer<String> errors;
    /** Only its first exception is reported. Used by the thread that reads the errors. */
    private boolean consumerFailed;

    /** Used by the calling thread. */
    private boolean hasWrittenLine;

    /** The time at which the write in progress began, or the maximum value if there is none. */
    private volatile long writeStart = Long.MAX_VALUE;

    private volatile boolean endedByGuard;
    private volatile boolean endedWithProgram;

    /**
     * Starts a child.
     *
     * @param command the program and its arguments
     * @param writeSeconds the time for which a write may block before the child is ended
     * @param errors the consumer of each line of the child's standard error, which is cut if it is very long, called on
     *     a separate thread
     * @throws IOException if it cannot be started
     */
    ChildProcess(List<String> command, double writeSeconds, Consumer<String> errors) throws IOException {
        this.errors = errors;
        ProcessBuilder builder = new ProcessBuilder(command);
        builder.environment().put(DetachedProcesses.VARIABLE, detached.mark());
        process = builder.start();
        detached.follow(process);
        input = process.getOutputStream();
        output = new ChildOutput(process.getInputStream());
        addExitHook();
        errorReader = startDaemon("faultline-child-errors", this::drainErrors);
        writeGuard = startDaemon("faultline-child-guard", () -> guardWrites(writeSeconds));
    }

    private void addExitHook() throws IOException {
        if (!ShutdownHooks.add(exitHook)) {
            killTree();
            throw new IOException("the program is ending");
        }
    }

    static Thread startDaemon(String name, Runnable work) {
        Thread thread = daemon(name, work);
        thread.start();
        return thread;
    }

    private static Thread daemon(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        return thread;
    }

    private void drainErrors() {
        try (BufferedReader reader =
                new BufferedReader(new InputStreamReader(process.getErrorStream(), StandardCharsets.UTF_8))) {
            StringBuilder line = new StringBuilder();
            for (int c = reader.read(); c >= 0; c = reader.read()) {
                if (c == '\n') {
                    addErrorLine(line.toString());
                    line.setLength(0);
                } else if (line.length() <= MAX_SHOWN_LENGTH) {
                    line.append((char) c);
                }
            }
            if (line.length() > 0) {
                addErrorLine(line.toString());
            }
        } catch (IOException ended) {
            // The stream was closed with the process.
        }
    }

    private void addErrorLine(String line) {
        synchronized (errorLines) {
            if (errorLines.size() == KEPT_LINES) {
                errorLines.removeFirst();
            }
            errorLines.addLast(MessageText.shortened(line, MAX_KEPT_LENGTH));
        }
        try {
            errors.accept(MessageText.shortened(line, MAX_SHOWN_LENGTH));
        } catch (RuntimeException e) {
            // The other lines must still be read: a child cannot write to a pipe that is closed.
            if (!consumerFailed) {
                consumerFailed = true;
                Thread reader = Thread.currentThread();
                reader.getUncaughtExceptionHandler().uncaughtException(reader, e);
            }
        }
    }

    /**
     * Each check counts the same, however late it is, so that time in which the program does not run is not counted.
     */
    private void guardWrites(double seconds) {
        long seen = Long.MAX_VALUE;
        ResponseTimeout timeout = new ResponseTimeout(process.toHandle(), seconds);
        while (process.isAlive()) {
            long start = writeStart;
            if (start != Long.MAX_VALUE && start == seen) {
                timeout.count(WRITE_CHECK_PERIOD);
            } else {
                timeout = new ResponseTimeout(process.toHandle(), seconds);
            }
            seen = start;
            if (timeout.isExhausted()) {
                endedByGuard = true;
                killTree();
            }
            try {
                process.waitFor(WRITE_CHECK_PERIOD, TimeUnit.NANOSECONDS);
            } catch (InterruptedException closed) {
                return;
            }
        }
    }

    /** Returns the last lines of the child's standard error, the oldest first. */
    List<String> lastErrorLines() {
        joinBriefly(errorReader);
        synchronized (errorLines) {
            return List.copyOf(errorLines);
        }
    }

    /**
     * Sends a line; the line break is added.
     *
     * @throws ProtocolException if the child does not read it
     */
    void send(String line) throws ProtocolException {
        writeStart = System.nanoTime();
        try {
            input.write((line + "\n").getBytes(StandardCharsets.UTF_8));
            input.flush();
            writeStart = Long.MAX_VALUE;
        } catch (IOException e) {
            writeStart = Long.MAX_VALUE;
            throw endOfInput();
        }
    }

    private ProtocolException endOfInput() {
        if (endedByGuard) {
            return new ProtocolException(ControllerProblem.NOT_READING);
        }
        return hasEnded() ? endOfChild("") : new ProtocolException(ControllerProblem.CLOSED_INPUT);
    }

    private ProtocolException endOfOutput() {
        Object place = output.hasPart() ? ControllerProblem.IN_LINE.with() : "";
        return hasEnded() ? endOfChild(place) : new ProtocolException(ControllerProblem.CLOSED_OUTPUT, place);
    }

    /** The streams of a child are closed shortly before it ends. */
    private boolean hasEnded() {
        return waitFor(1);
    }

    private ProtocolException endOfChild(Object place) {
        boolean isQuiet = process.exitValue() == 0 && place.equals("");
        return new ProtocolException(
                ControllerProblem.ENDED, process.exitValue(), isQuiet ? ControllerProblem.UNTIL_END.with() : place);
    }

    /**
     * Waits for a line. Time in which other programs prevent this one or the child from running does not count.
     *
     * @param seconds the time limit; infinity for no limit
     * @return the line without its line break
     * @throws ProtocolException if no line arrives in time, it is too long, or the child has ended
     */
    String receive(double seconds) throws IOException, ProtocolException {
        ResponseTimeout timeout = new ResponseTimeout(process.toHandle(), seconds);
        for (String line = output.next(); ; line = output.next()) {
            if (line != null) {
                hasWrittenLine = true;
                return line;
            }
            if (!output.fill()) {
                long start = System.nanoTime();
                awaitOutput(timeout, seconds);
                timeout.count(Math.min(LONGEST_WAIT, System.nanoTime() - start));
            }
        }
    }

    /** Returns whether a line has arrived that {@link #receive} would return at once. */
    boolean hasLine() throws IOException {
        return output.hasLine();
    }

    private void awaitOutput(ResponseTimeout timeout, double seconds) throws IOException, ProtocolException {
        double waited = timeout.waited();
        if (waited < SPIN) {
            Thread.yield();
            return;
        }
        if (output.hasEnded() || !process.isAlive() && !output.isLeft()) {
            throw endOfOutput();
        }
        if (timeout.isExhausted()) {
            throw new ProtocolException(ControllerProblem.SILENT, seconds, silenceHint());
        }
        if (Thread.currentThread().isInterrupted()) {
            // Waiting would end at once, and so would use a whole processor.
            throw new InterruptedIOException("the wait for its answer was interrupted");
        }
        if (waited > SILENCE) {
            output.lookForEnd();
        }
        LockSupport.parkNanos(Math.min(LONGEST_SLEEP, (long) waited / 8));
    }

    private Object silenceHint() {
        if (output.hasPart()) {
            return ControllerProblem.OPEN_LINE.with();
        }
        return hasWrittenLine ? "" : ControllerProblem.UNFLUSHED.with();
    }

    /**
     * Closes the child's input, waits, and then ends the child and its descendants if they are still alive. A daemon
     * thread does this, so that a child has its time to end also if the calling thread is interrupted, which then does
     * not wait.
     */
    @Override
    public void close() {
        startCloser();
        try {
            closer.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Closes the child as {@link #close} does, and returns whether one of the complete lines that it has left or writes
     * until its end is wanted.
     */
    boolean closeAndFind(Predicate<String> wanted) {
        startCloser();
        boolean found = false;
        try {
            boolean alive = true;
            while (!found && alive && !Thread.currentThread().isInterrupted()) {
                // Asked first: what the child writes before its end is then read below.
                alive = process.isAlive();
                found = find(wanted);
                LockSupport.parkNanos(alive && !found ? LONGEST_SLEEP : 0);
            }
        } catch (IOException | ProtocolException unreadable) {
            // The child was ended, or what it writes is not a line.
        }
        close();
        return found;
    }

    private boolean find(Predicate<String> wanted) throws IOException, ProtocolException {
        do {
            for (String line = output.next(); line != null; line = output.next()) {
                if (wanted.test(line)) {
                    return true;
                }
            }
        } while (output.fill());
        return false;
    }

    private synchronized void startCloser() {
        if (closer.getState() == Thread.State.NEW) {
            closer.start();
        }
    }

    private void end() {
        Set<ProcessHandle> descendants = descendants(process.toHandle());
        closeInput();
        if (!waitFor(GRACE_SECONDS)) {
            process.destroy();
            if (!waitFor(GRACE_SECONDS)) {
                killTree();
                waitFor(GRACE_SECONDS);
            }
        }
        descendants.forEach(ProcessHandle::destroyForcibly);
        detached.killAll();
        joinBriefly(errorReader);
        writeGuard.interrupt();
        ShutdownHooks.remove(exitHook);
    }

    /** Returns whether the program is ending, so that an end of the child is not its own fault. */
    boolean isEndedWithProgram() {
        return endedWithProgram;
    }

    /** Leaves a child that is being closed its time to end, and kills any other. */
    private void endWithProgram() {
        endedWithProgram = true;
        if (closer.getState() == Thread.State.NEW) {
            killTree();
        } else {
            close();
        }
    }

    private void closeInput() {
        Thread inputCloser = startDaemon("faultline-child-input", () -> {
            try {
                input.close();
            } catch (IOException alreadyClosed) {
                // The child has closed its end of the pipe.
            }
        });
        joinBriefly(inputCloser);
    }

    private boolean waitFor(long seconds) {
        try {
            return process.waitFor(seconds, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    private static void joinBriefly(Thread thread) {
        try {
            thread.join(500);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Returns the descendants of a process; none if they cannot be listed, as without free file descriptors. */
    static Set<ProcessHandle> descendants(ProcessHandle process) {
        try {
            return DetachedProcesses.listed(process::descendants);
        } catch (IOException unknown) {
            return Set.of();
        }
    }

    private void killTree() {
        descendants(process.toHandle()).forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
        detached.killAll();
    }
}
