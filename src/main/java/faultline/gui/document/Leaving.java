package faultline.gui.document;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import java.util.function.Consumer;

/**
 * The questions before the window is closed or another scenario is opened. They are asked again after a file has been
 * written, because the window can be used in that time. What the user has chosen to lose is not asked about twice.
 */
public final class Leaving {

    private final Consumer<Leaving> questions;
    private final Set<Object> discarded = Collections.newSetFromMap(new IdentityHashMap<>());

    private Leaving(Consumer<Leaving> questions) {
        this.questions = questions;
    }

    /** Asks questions, the last of which leaves if the user agrees. */
    public static void begin(Consumer<Leaving> questions) {
        new Leaving(questions).ask();
    }

    /** Asks the questions, again if they have been asked. */
    public void ask() {
        questions.accept(this);
    }

    /** Notes that the user has chosen to lose something. */
    public void discard(Object loss) {
        discarded.add(loss);
    }

    /** Returns whether the user has chosen to lose something. */
    public boolean isDiscarded(Object loss) {
        return discarded.contains(loss);
    }
}
