package faultline.gui.document;

/** Makes something slowly, off the event dispatch thread. */
@FunctionalInterface
interface Maker<T> {

    /** Says how far it has come, and gives up where it is no longer wanted. */
    T make(UnderWay way) throws Exception;
}
