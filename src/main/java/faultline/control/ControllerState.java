package faultline.control;

import java.util.Objects;

/** A state of a controller: one of the wall follower's six, or one that another controller names. */
public sealed interface ControllerState permits FollowerState, ControllerState.Named {

    /** {@return the name, such as FOLLOW} */
    String name();

    /**
     * {@return the state of a name: the wall follower's if it has one of that name}
     *
     * @param name the name of the state
     */
    static ControllerState of(String name) {
        for (FollowerState state : FollowerState.values()) {
            if (state.name().equals(name)) {
                return state;
            }
        }
        return new Named(name);
    }

    /**
     * A state that is not one of the wall follower's; {@link #of} makes it.
     *
     * @param name any text but a name of one of the wall follower's states
     */
    record Named(String name) implements ControllerState {

        /**
         * Creates a state.
         *
         * @param name any text but a name of one of the wall follower's states
         * @throws IllegalArgumentException if the wall follower has a state of the same name
         * @throws NullPointerException if the name is null
         */
        public Named {
            Objects.requireNonNull(name, "name");
            for (FollowerState state : FollowerState.values()) {
                if (state.name().equals(name)) {
                    throw new IllegalArgumentException("the wall follower has a state of its own called " + name);
                }
            }
        }

        /**
         * Implemented explicitly, because the virtual machine takes milliseconds to generate this method of a record.
         */
        @Override
        public int hashCode() {
            return name.hashCode();
        }

        @Override
        public String toString() {
            return name;
        }
    }
}
