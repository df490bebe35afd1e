package faultline.gui;

/** The threads on which the window does slow work. */
public final class BackgroundThreads {

    private BackgroundThreads() {}

    /** Returns how many work. */
    public static long count() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals("faultline-background"))
                .count();
    }

    /** Waits until none works. What each has found is in the event queue before. */
    public static void awaitEnd() {
        Await.until("the end of the work in the background", () -> count() == 0);
    }
}
