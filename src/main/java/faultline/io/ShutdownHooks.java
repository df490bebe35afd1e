package faultline.io;

/** Adds and removes the hooks that run when the process ends, also while it is ending. */
public final class ShutdownHooks {
    private ShutdownHooks() {}

    /**
     * Adds a hook, unless the process is ending.
     *
     * @param hook a thread that has not been started; it is started when the process ends
     * @return whether the hook was added
     */
    public static boolean add(Thread hook) {
        try {
            Runtime.getRuntime().addShutdownHook(hook);
            return true;
        } catch (IllegalStateException ending) {
            return false;
        }
    }

    /**
     * Removes a hook, unless the process is ending: it has been started then.
     *
     * @param hook the hook, which may have been added or not
     */
    public static void remove(Thread hook) {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException ending) {
            // All hooks have been started.
        }
    }
}
