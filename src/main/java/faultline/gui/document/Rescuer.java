package faultline.gui.document;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Function;
import java.util.logging.Level;
import java.util.logging.Logger;

/** Looks for what a crash has left, and offers it. */
public final class Rescuer {

    private static final Logger LOG = Logger.getLogger(Rescuer.class.getName());

    /** What is to become of edits that a crash has left. */
    public enum Answer {
        /** They are open again. */
        RECOVER,
        /** They are given up. */
        DISCARD,
        /** They are offered again at the next start. */
        LATER
    }

    private Rescuer() {
    }

    /**
     * Looks, soon. What is offered is taken away afterwards, unless the user puts it off: if it was taken, the window
     * that has it keeps it under its own number.
     *
     * @param recovery where to look
     * @param offer asks the user, on the event dispatch thread
     * @param otherwise done on the event dispatch thread where nothing was left
     */
    public static void start(Recovery recovery, Function<Recovery.Rescue, Answer> offer, Runnable otherwise) {
        Background.run(recovery::left, left -> left.ifPresentOrElse(rescue -> offer(recovery, rescue, offer), otherwise), why -> {
            failed(why);
            otherwise.run();
        });
    }

    private static void offer(Recovery recovery, Recovery.Rescue rescue, Function<Recovery.Rescue, Answer> offer) {
        Answer answer = offer.apply(rescue);
        if (answer != Answer.LATER) {
            Background.run(() -> settle(recovery, rescue, answer == Answer.RECOVER), done -> {
            }, Rescuer::failed);
        }
    }

    private static Optional<Recovery.Rescue> settle(Recovery recovery, Recovery.Rescue rescue, boolean taken) throws IOException {
        if (taken) {
            recovery.adopt(rescue);
        } else {
            recovery.forget(rescue.kept());
        }
        return Optional.of(rescue);
    }

    private static void failed(Throwable why) {
        LOG.log(Level.WARNING, "what a crash has left cannot be read", why);
    }
}
