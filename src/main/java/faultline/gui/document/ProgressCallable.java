package faultline.gui.document;

/** Makes something slowly, off the event dispatch thread. */
@FunctionalInterface
interface ProgressCallable<T> {

    /** Says how far it has come, and gives up where it is no longer wanted. */
    T call(TaskProgress way) throws Exception;
}
