package faultline.external;

import java.nio.file.Path;
import java.util.List;

/** Makes the controllers of jars available to the code of a thread, and of the threads that it starts. */
public final class ControllerJars {

    private ControllerJars() {}

    /**
     * Makes the controllers of jars available to the calling thread, and to threads that it starts, in the place of
     * those of earlier jars. Changes nothing without a jar.
     *
     * @param jars the jar files
     */
    public static void use(List<Path> jars) {
        if (!jars.isEmpty()) {
            Thread.currentThread().setContextClassLoader(loader(jars));
        }
    }

    private static ClassLoader loader(List<Path> jars) {
        return new JarClassLoader(jars, ControllerJars.class.getClassLoader());
    }

    /**
     * An action that uses controllers.
     *
     * @param <T> the type of its result
     * @param <X> the exceptions that it throws
     */
    @FunctionalInterface
    public interface JarAction<T, X extends Exception> {

        /**
         * {@return the result}
         *
         * @throws X if the action fails
         */
        T call() throws X;
    }

    /**
     * {@return the result of an action that is called with the current controllers of some jars available} They are
     * also available to the threads that the action starts.
     *
     * @param <T> the type of the result
     * @param <X> the exceptions of the action
     * @param jars the jar files
     * @param action the action, which is called on the calling thread
     * @throws X if the action throws it
     */
    public static <T, X extends Exception> T callWith(List<Path> jars, JarAction<T, X> action) throws X {
        ClassLoader loader = loader(jars);
        Thread thread = Thread.currentThread();
        ClassLoader before = thread.getContextClassLoader();
        thread.setContextClassLoader(loader);
        try {
            return action.call();
        } finally {
            thread.setContextClassLoader(before);
        }
    }
}
