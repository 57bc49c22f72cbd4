"""RoboComp's interfaces as Slice, written independently of our own, for the real Ice."""

from string import Template

#: The orders of members in the three layouts.
ORDERS = {
    "robot": {
        "state": "bool isMoving; float x; float z; float alpha; float correctedX; float correctedZ;"
        " float correctedAlpha; float advVx; float advVz; float rotV;",
        "laser": "int staticConf; int maxMeasures; int maxDegrees; int maxRange; int minRange;"
        " int iniRange; int endRange; int cluster; int sampleRate; float angleRes; float angleIni;"
        " string driver; string device;",
        "motor": "int p; int v; int temperature; bool isMoving; float pos; float vel; float power;"
        " string timeStamp;",
        "params": "bool invertedSign; byte busId; float minPos; float maxPos; float maxVelocity;"
        " float zeroPos; float stepsRange; float maxDegrees; float offset; float unitsRange;"
        " string name;",
        "bus": "int numMotors; int baudRate; int basicPeriod; string handler; string device;",
        "position": "float position; float maxSpeed; string name;",
        "velocity": "float velocity; float maxAcc; string name;",
        "emotions": "void expressNeutral(); void talking(bool setTalk);",
    },
    "tool": {
        "state": "bool isMoving; float x; float z; float alpha; float correctedX; float correctedZ;"
        " float correctedAlpha; float advVx; float advVz; float rotV;",
        "laser": "int staticConf; int maxMeasures; int maxDegrees; int maxRange; int minRange;"
        " int iniRange; int endRange; int cluster; int sampleRate; float angleRes; float angleIni;"
        " string driver; string device;",
        "motor": "float pos; float vel; float power; string timeStamp; int p; int v;"
        " bool isMoving; int temperature;",
        "params": "string name; byte busId; float minPos; float maxPos; float maxVelocity;"
        " float zeroPos; float stepsRange; float maxDegrees; bool invertedSign; float offset;"
        " float unitsRange;",
        "bus": "string handler; string device; int numMotors; int baudRate; int basicPeriod;",
        "position": "string name; float position; float maxSpeed;",
        "velocity": "string name; float velocity; float maxAcc;",
        "emotions": "void expressNeutral();",
    },
    "2020": {
        "state": "float x; float correctedX; float z; float correctedZ; float alpha;"
        " float correctedAlpha; float advVx; float advVz; float rotV; bool isMoving;",
        "laser": "string driver; string device; int staticConf; int maxMeasures; int maxDegrees;"
        " int maxRange; int minRange; int iniRange; int endRange; int cluster; int sampleRate;"
        " float angleRes; float angleIni;",
        "motor": "float pos; float vel; float power; string timeStamp; int p; int v;"
        " bool isMoving; int temperature;",
        "params": "string name; byte busId; float minPos; float maxPos; float maxVelocity;"
        " float zeroPos; float stepsRange; float maxDegrees; bool invertedSign; float offset;"
        " float unitsRange;",
        "bus": "string handler; string device; int numMotors; int baudRate; int basicPeriod;",
        "position": "string name; float position; float maxSpeed;",
        "velocity": "string name; float velocity; float maxAcc;",
        "emotions": "void talking(bool setTalk); void listening(bool setListening);"
        " void pupposition(float x, float y); void isanybodythere(bool isAny);",
    },
}

_TEXT = Template("""
module RoboCompGenericBase
{
  exception HardwareFailedException { string what; };
  struct TBaseState { $state };
  interface GenericBase
  {
    void getBaseState(out TBaseState state) throws HardwareFailedException;
    void getBasePose(out int x, out int z, out float alpha) throws HardwareFailedException;
  };
};

module RoboCompDifferentialRobot
{
  interface DifferentialRobot
  {
    void getBaseState(out RoboCompGenericBase::TBaseState state)
      throws RoboCompGenericBase::HardwareFailedException;
    void getBasePose(out int x, out int z, out float alpha)
      throws RoboCompGenericBase::HardwareFailedException;
    void setSpeedBase(float adv, float rot) throws RoboCompGenericBase::HardwareFailedException;
    void stopBase() throws RoboCompGenericBase::HardwareFailedException;
    void resetOdometer() throws RoboCompGenericBase::HardwareFailedException;
    void setOdometer(RoboCompGenericBase::TBaseState state)
      throws RoboCompGenericBase::HardwareFailedException;
    void setOdometerPose(int x, int z, float alpha)
      throws RoboCompGenericBase::HardwareFailedException;
    void correctOdometer(int x, int z, float alpha)
      throws RoboCompGenericBase::HardwareFailedException;
  };
};

module RoboCompLaser
{
  struct LaserConfData { $laser };
  struct TData { float angle; float dist; };
  sequence<TData> TLaserData;
  interface Laser
  {
    TLaserData getLaserData();
    TLaserData getLaserAndBStateData(out RoboCompGenericBase::TBaseState bState);
    LaserConfData getLaserConfData();
  };
};

module RoboCompJointMotor
{
  exception HardwareFailedException { string what; };
  exception UnknownMotorException { string what; };
  exception CollisionException { string what; };
  struct MotorState { $motor };
  dictionary<string, MotorState> MotorStateMap;
  struct MotorParams { $params };
  struct BusParams { $bus };
  struct MotorGoalPosition { $position };
  struct MotorGoalVelocity { $velocity };
  sequence<MotorParams> MotorParamsList;
  sequence<MotorGoalPosition> MotorGoalPositionList;
  sequence<MotorGoalVelocity> MotorGoalVelocityList;
  sequence<string> MotorList;
  interface JointMotor
  {
    MotorParamsList getAllMotorParams();
    void getAllMotorState(out MotorStateMap mstateMap) throws UnknownMotorException;
    BusParams getBusParams();
    MotorParams getMotorParams(string motor) throws UnknownMotorException;
    MotorState getMotorState(string motor) throws UnknownMotorException;
    MotorStateMap getMotorStateMap(MotorList mList) throws UnknownMotorException;
    void setPosition(MotorGoalPosition goal)
      throws UnknownMotorException, HardwareFailedException, CollisionException;
    void setSyncPosition(MotorGoalPositionList listGoals)
      throws UnknownMotorException, HardwareFailedException;
    void setSyncVelocity(MotorGoalVelocityList listGoals)
      throws UnknownMotorException, HardwareFailedException;
    void setSyncZeroPos() throws UnknownMotorException, HardwareFailedException;
    void setVelocity(MotorGoalVelocity goal) throws UnknownMotorException, HardwareFailedException;
    void setZeroPos(string name) throws UnknownMotorException, HardwareFailedException;
  };
};

module RoboCompDisplay
{
  exception HardwareFailedException { string what; };
  sequence<byte> ImgData;
  struct Image { int width; int height; int depth; ImgData Img; };
  interface Display
  {
    void setImage(Image img) throws HardwareFailedException;
    void setImageFromFile(string pathImg) throws HardwareFailedException;
  };
};

module RoboCompEmotionalMotor
{
  interface EmotionalMotor
  {
    void expressJoy();
    void expressSadness();
    void expressSurprise();
    void expressFear();
    void expressAnger();
    void expressDisgust();
    $emotions
  };
};

module RoboCompRGBD
{
  exception HardwareFailedException { string what; };
  enum Registration { None, DepthInColor, ColorInDepth };
  sequence<byte> imgType;
  sequence<float> depthType;
  struct ColorRGB { byte red; byte green; byte blue; };
  struct PointXYZ { float x; float y; float z; float w; };
  sequence<float> DepthSeq;
  sequence<ColorRGB> ColorSeq;
  sequence<PointXYZ> PointSeq;
  struct CameraParameters { int focal; int width; int height; int size; int FPS; };
  struct TRGBDParams
  {
    CameraParameters color;
    CameraParameters depth;
    int timerPeriod;
    bool talkToBase;
    bool talkToJointMotor;
    string driver;
    string device;
  };
  interface RGBD
  {
    TRGBDParams getRGBDParams();
    idempotent void setRegistration(Registration value) throws HardwareFailedException;
    idempotent Registration getRegistration() throws HardwareFailedException;
    idempotent void getData(out imgType rgbMatrix, out depthType distanceMatrix,
      out RoboCompJointMotor::MotorStateMap hState, out RoboCompGenericBase::TBaseState bState)
      throws HardwareFailedException;
    idempotent void getImage(out ColorSeq color, out DepthSeq depth, out PointSeq points,
      out RoboCompJointMotor::MotorStateMap hState, out RoboCompGenericBase::TBaseState bState)
      throws HardwareFailedException;
  };
};

module RoboCompApriltag
{
  struct tag { int id; int cx; int cy; string cameraId; };
  sequence<tag> tagsList;
  sequence<byte> ImgType;
  struct TImage { int width; int height; int depth; ImgType image; };
  interface Apriltag { tagsList processimage(TImage frame); };
};

module RoboCompEmotionRecognition
{
  struct SEmotion { int x; int y; int w; int h; string emotion; };
  sequence<SEmotion> EmotionList;
  sequence<byte> ImgType;
  struct TImage { int width; int height; int depth; ImgType image; };
  interface EmotionRecognition { EmotionList processimage(TImage frame); };
};

module RoboCompCommonBehavior
{
  enum State { Starting, Running };
  struct Parameter { bool editable; string value; string type; };
  dictionary<string, Parameter> ParameterList;
  interface CommonBehavior
  {
    idempotent int getPeriod();
    void setPeriod(int period);
    idempotent int timeAwake();
    void killYourSelf();
    ParameterList getParameterList();
    void setParameterList(ParameterList l);
    void reloadConfig();
    State getState();
  };
};
""")


def slice_text(layout):
    """Return the interfaces in a layout, as a file that Ice loads."""
    return _TEXT.substitute(ORDERS[layout])
