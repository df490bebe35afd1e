package faultline.external;

import java.nio.file.Path;
import java.util.List;

/** Makes the controllers of jars available to the code of a thread, and of the threads that it starts. */
public final class ControllerJars {

    private ControllerJars() {}

    /**
     * Adds a jar with controllers to those that the calling thread, and threads that it starts, can find.
     *
     * @param jar the jar file
     */
    public static void add(Path jar) {
        Thread.currentThread().setContextClassLoader(loader(List.of(jar)));
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
