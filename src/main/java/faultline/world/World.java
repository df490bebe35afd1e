package faultline.world;

import java.util.Optional;

/** The live world; belongs to one thread. */
public final class World {

    private World() {
    }

    /**
     * Applies a command.
     *
     * @param command what is to be done
     * @return why it was refused, empty where it was done
     */
    public Optional<String> apply(Command command) {
        throw new UnsupportedOperationException();
    }
}
